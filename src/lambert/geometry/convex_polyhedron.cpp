#include "lambert/base/error.h"
#include "lambert/geometry/shape.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// A square in the plane, large enough to contain the face.
std::vector<Vec3d> large_square(Vec3d normal, double offset, double half) {
  const Vec3d helper = std::abs(normal.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d s = glm::normalize(glm::cross(helper, normal)), t = glm::cross(normal, s), centre = offset * normal;
  return {centre - half * s - half * t, centre + half * s - half * t, centre + half * s + half * t,
          centre - half * s + half * t};
}

/// Keeps the part where dot(normal, p) <= offset (Sutherland and Hodgman 1974).
std::vector<Vec3d> clip(const std::vector<Vec3d>& face, Vec3d normal, double offset) {
  std::vector<Vec3d> kept;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3d a = face[i], b = face[(i + 1) % face.size()];
    const double da = glm::dot(normal, a) - offset, db = glm::dot(normal, b) - offset;
    if (da <= 0) kept.push_back(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

std::vector<Vec3> without_repeats(const std::vector<Vec3d>& face, double tolerance) {
  std::vector<Vec3> vertices;
  for (std::size_t i = 0; i < face.size(); ++i)
    if (glm::length(face[i] - face[(i + 1) % face.size()]) > tolerance) vertices.emplace_back(face[i]);
  return vertices;
}

}  // namespace

ConvexPolyhedron::ConvexPolyhedron(std::vector<Plane> planes) : planes_(std::move(planes)) {
  constexpr double enormous = 1e6;  // in units of the largest offset
  double scale = 1e-6;
  for (Plane& p : planes_) {
    const float l = length(p.normal);
    if (!(l > 0) || !std::isfinite(l) || !std::isfinite(p.offset))
      throw Error("a plane of a convex polyhedron has no direction");
    p.normal /= l, p.offset /= l;
    scale = std::max(scale, static_cast<double>(std::abs(p.offset)));
  }
  float sum = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    std::vector<Vec3d> face =
        large_square(Vec3d(planes_[i].normal), static_cast<double>(planes_[i].offset), enormous * scale);
    for (std::size_t j = 0; j < planes_.size() && !face.empty(); ++j)
      if (j != i) face = clip(face, Vec3d(planes_[j].normal), static_cast<double>(planes_[j].offset));
    const std::vector<Vec3> vertices = without_repeats(face, 1e-9 * scale);
    if (vertices.size() < 3) continue;
    for (const Vec3 v : vertices) bounds_.add(v);
    faces_.emplace_back(vertices);
    cumulative_area_.push_back(sum += faces_.back().area());
  }
  if (faces_.size() < 4) throw Error("the planes of a convex polyhedron enclose nothing");
  if (static_cast<double>(bounds_.radius()) > 0.1 * enormous * scale)
    throw Error("the planes of a convex polyhedron do not enclose a finite body");
}

/// Enters at the last front-facing plane and leaves at the first back-facing one; hit if it enters before it leaves.
std::optional<ShapeHit> ConvexPolyhedron::intersect(const Ray& ray) const {
  float enter = -std::numeric_limits<float>::infinity(), leave = std::numeric_limits<float>::infinity();
  const Plane *enter_plane = nullptr, *leave_plane = nullptr;
  for (const Plane& p : planes_) {
    const float towards = dot(p.normal, ray.direction), outside = dot(p.normal, ray.origin) - p.offset;
    if (towards == 0) {
      if (outside > 0) return std::nullopt;
      continue;
    }
    const float t = -outside / towards;
    if (towards < 0 && t > enter) enter = t, enter_plane = &p;
    if (towards > 0 && t < leave) leave = t, leave_plane = &p;
  }
  if (!(enter <= leave)) return std::nullopt;
  const bool from_outside = enter >= ray.t_min;
  const float t = from_outside ? enter : leave;
  const Plane* plane = from_outside ? enter_plane : leave_plane;
  if (!plane || !(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;

  ShapeHit hit;
  hit.t = t;
  hit.normal = plane->normal;
  const Vec3 place = ray.at(t) - bounds_.min, size = bounds_.diagonal();
  const int drop = std::abs(hit.normal.x) > std::abs(hit.normal.y)
                       ? (std::abs(hit.normal.x) > std::abs(hit.normal.z) ? 0 : 2)
                       : (std::abs(hit.normal.y) > std::abs(hit.normal.z) ? 1 : 2);
  const int a = (drop + 1) % 3, b = (drop + 2) % 3;
  hit.uv = {std::clamp(place[a] / size[a], 0.0f, 1.0f), std::clamp(place[b] / size[b], 0.0f, 1.0f)};
  Vec3 axis(0);
  axis[a] = size[a];
  hit.dpdu = axis - dot(axis, hit.normal) * hit.normal;
  return hit;
}

Bounds3 ConvexPolyhedron::bounds() const { return bounds_; }
float ConvexPolyhedron::area() const { return cumulative_area_.back(); }

ShapeSample ConvexPolyhedron::sample(Vec2 u) const {
  const float wanted = u.x * area();
  const auto above = std::upper_bound(cumulative_area_.begin(), cumulative_area_.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(above - cumulative_area_.begin());
  const float before = i ? cumulative_area_[i - 1] : 0;
  return faces_[i].sample(
      {std::clamp((wanted - before) / (cumulative_area_[i] - before), 0.0f, one_minus_epsilon), u.y});
}

}  // namespace lambert
