#include "lambert/base/error.h"
#include "lambert/geometry/ray_tests.h"
#include "lambert/geometry/shape.h"
#include "lambert/polygon/queries/normal.h"
#include "lambert/sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lambert {
namespace {

std::vector<std::uint32_t> whole_face(const std::vector<Vec3>& vertices) {
  std::vector<std::uint32_t> face(vertices.size());
  std::iota(face.begin(), face.end(), 0u);
  return face;
}

std::vector<Vec3> checked(std::vector<Vec3> vertices) {
  if (vertices.size() < 3) throw Error("a polygon needs at least 3 vertices, got " + std::to_string(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 v = vertices[i];
    if (!is_finite(v)) throw Error("vertex " + std::to_string(i) + " of a polygon is not finite");
  }
  return vertices;
}

Bounds3 bounds_of(const std::vector<Vec3>& vertices) {
  Bounds3 box;
  for (const Vec3 v : vertices) box.add(v);
  return box;
}

Vec3 checked_normal(const std::vector<Vec3>& vertices, const Bounds3& box) {
  const Vec3d area = polygon::newell_sum(vertices.size(), [&](std::size_t i) { return Vec3d(vertices[i]); });
  const double twice_area = glm::length(area), extent = glm::length(Vec3d(box.max) - Vec3d(box.min));
  if (!(twice_area > 1e-12 * extent * extent)) throw Error("a polygon's vertices lie on one line");
  const Vec3d n = area / twice_area;
  // Coordinates far from the origin cannot be given more exactly than this.
  const double rounding = 1e-6 * glm::length(glm::max(glm::abs(Vec3d(box.min)), glm::abs(Vec3d(box.max))));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (std::abs(glm::dot(Vec3d(vertices[i]) - Vec3d(vertices[0]), n)) > 1e-3 * extent + rounding)
      throw Error("a polygon is not planar: vertex " + std::to_string(i) + " lies off the plane of the others");
  return Vec3(n);
}

std::vector<Triangle> triangulated(const std::vector<Vec3>& vertices) {
  std::vector<Triangle> triangles;
  triangulate_face(vertices, whole_face(vertices), triangles);
  return triangles;
}

std::vector<float> areas(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  std::vector<float> a;
  for (const Triangle& t : triangles)
    a.push_back(0.5f * length(cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]])));
  return a;
}

}  // namespace

Polygon::Polygon(std::vector<Vec3> vertices)
    : vertices_(checked(std::move(vertices))),
      bounds_(bounds_of(vertices_)),
      normal_(checked_normal(vertices_, bounds_)),
      drop_axis_(polygon::dominant_axis(Vec3d(normal_))),
      triangles_(triangulated(vertices_)),
      triangle_choice_(areas(vertices_, triangles_)) {
  const std::vector<float> parts = areas(vertices_, triangles_);
  area_ = std::accumulate(parts.begin(), parts.end(), 0.0f);
}

/// A ray in the polygon's plane misses it.
std::optional<ShapeHit> Polygon::intersect(const Ray& ray) const {
  const Vec3d n(normal_), o(ray.origin), d(ray.direction);
  const double along = glm::dot(d, n);
  if (along == 0) return std::nullopt;
  const double t = glm::dot(Vec3d(vertices_[0]) - o, n) / along;
  const auto rounded = static_cast<float>(t);
  if (!(rounded >= ray.t_min && rounded <= ray.t_max)) return std::nullopt;
  const Vec3d p = o + t * d;
  if (!inside_projected_polygon(p, vertices_, drop_axis_)) return std::nullopt;
  return hit_at(rounded, Vec3(p));
}

Vec2 Polygon::uv_at(Vec3 position) const {
  const int a = (drop_axis_ + 1) % 3, b = (drop_axis_ + 2) % 3;
  const Vec3 place = position - bounds_.min, size = bounds_.diagonal();
  return {std::clamp(place[a] / size[a], 0.0f, 1.0f), std::clamp(place[b] / size[b], 0.0f, 1.0f)};
}

ShapeHit Polygon::hit_at(float t, Vec3 position) const {
  // Along u one coordinate changes, the next stays, and the dropped one keeps to the plane n.p = const.
  const int a = (drop_axis_ + 1) % 3;
  Vec3 dpdu(0);
  dpdu[a] = bounds_.diagonal()[a];
  dpdu[drop_axis_] = -dpdu[a] * normal_[a] / normal_[drop_axis_];
  return {.t = t, .position = position, .normal = normal_, .dpdu = dpdu, .uv = uv_at(position)};
}

ShapeSample Polygon::sample(Vec2 u) const {
  float within = 0;
  const Triangle& t = triangles_[triangle_choice_.sample(u.x, within).index];
  const Vec2 b = square_to_triangle({within, u.y});
  const Vec3 p =
      vertices_[t[0]] + b.x * (vertices_[t[1]] - vertices_[t[0]]) + b.y * (vertices_[t[2]] - vertices_[t[0]]);
  return {p, normal_, uv_at(p)};
}

}  // namespace lambert
