#include "lambert/base/error.h"
#include "lambert/geometry/mesh.h"
#include "lambert/geometry/ray_tests.h"
#include "lambert/geometry/shape.h"
#include "lambert/sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lambert {
namespace {

/// Sum over the edges of coordinate differences times sums: twice the area along the normal (Newell; row PG-18).
Vec3d newell_normal(const std::vector<Vec3>& v) {
  Vec3d n(0);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec3d a(v[i] - v[0]), b(v[(i + 1) % v.size()] - v[0]);
    n += Vec3d((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
  }
  return n;
}

float triangle_area(const std::vector<Vec3>& v, const std::array<std::size_t, 3>& t) {
  return 0.5f * length(cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]));
}

}  // namespace

Polygon::Polygon(std::vector<Vec3> vertices) : vertices_(std::move(vertices)) {
  if (vertices_.size() < 3) throw Error("a polygon needs at least 3 vertices, got " + std::to_string(vertices_.size()));
  const Vec3d n = newell_normal(vertices_);
  const double twice_area = glm::length(n), extent = static_cast<double>(length(bounds().diagonal()));
  if (!(twice_area > 1e-12 * extent * extent)) throw Error("a polygon's vertices lie on one line");
  normal_ = Vec3(n / twice_area);
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    if (std::abs(dot(vertices_[i] - vertices_[0], normal_)) > 1e-3f * static_cast<float>(extent))
      throw Error("a polygon is not planar: vertex " + std::to_string(i) + " lies off the plane of the others");
  drop_axis_ = dominant_axis(normal_);

  std::vector<std::uint32_t> face(vertices_.size());
  std::iota(face.begin(), face.end(), 0u);
  std::vector<Triangle> triangles;
  triangulate_face(vertices_, face, triangles);
  float sum = 0;
  for (const Triangle& t : triangles) {
    triangles_.push_back({t[0], t[1], t[2]});
    cumulative_area_.push_back(sum += triangle_area(vertices_, triangles_.back()));
  }
}

std::optional<ShapeHit> Polygon::intersect(const Ray& ray) const {
  const float along = dot(ray.direction, normal_);
  if (along == 0) return std::nullopt;
  const float t = dot(vertices_[0] - ray.origin, normal_) / along;
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  const Vec3 p = ray.at(t);
  if (!inside_projected_polygon(p, vertices_, drop_axis_)) return std::nullopt;
  const Bounds3 box = bounds();
  const int a = (drop_axis_ + 1) % 3, b = (drop_axis_ + 2) % 3;
  const Vec3 size = box.diagonal(), place = p - box.min;
  ShapeHit hit;
  hit.t = t;
  hit.normal = normal_;
  hit.uv = {std::clamp(place[a] / size[a], 0.0f, 1.0f), std::clamp(place[b] / size[b], 0.0f, 1.0f)};
  Vec3 axis(0);
  axis[a] = size[a];
  hit.dpdu = axis - dot(axis, normal_) * normal_;
  return hit;
}

Bounds3 Polygon::bounds() const {
  Bounds3 box;
  for (const Vec3 v : vertices_) box.add(v);
  return box;
}

float Polygon::area() const { return cumulative_area_.back(); }

ShapeSample Polygon::sample(Vec2 u) const {
  const float wanted = u.x * area();
  const auto above = std::upper_bound(cumulative_area_.begin(), cumulative_area_.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(above - cumulative_area_.begin());
  const float before = i ? cumulative_area_[i - 1] : 0;
  const float within = std::clamp((wanted - before) / (cumulative_area_[i] - before), 0.0f, one_minus_epsilon);
  const Vec2 b = square_to_triangle({within, u.y});
  const auto& t = triangles_[i];
  const Vec3 p =
      vertices_[t[0]] + b.x * (vertices_[t[1]] - vertices_[t[0]]) + b.y * (vertices_[t[2]] - vertices_[t[0]]);
  const auto hit = intersect(Ray{p + normal_, -normal_});
  return {p, normal_, hit ? hit->uv : Vec2(0)};
}

}  // namespace lambert
