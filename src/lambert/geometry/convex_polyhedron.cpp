#include "lambert/base/error.h"
#include "lambert/geometry/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert {
namespace {

struct WidePlane {
  Vec3d normal;
  double offset;
  double height(Vec3d p) const { return glm::dot(normal, p) - offset; }
};

/// With unit normals, and each plane once.
std::vector<WidePlane> distinct(const std::vector<ConvexPolyhedron::Plane>& planes) {
  std::vector<WidePlane> kept;
  for (const auto& plane : planes) {
    const Vec3d n(plane.normal);
    const double l = glm::length(n);
    if (!(l > 0) || !std::isfinite(l) || !std::isfinite(plane.offset))
      throw Error("a plane of a convex polyhedron has no direction or is not finite");
    const WidePlane wide{n / l, static_cast<double>(plane.offset) / l};
    const bool seen = std::any_of(kept.begin(), kept.end(), [&](const WidePlane& k) {
      return glm::length(k.normal - wide.normal) < 1e-7 &&
             std::abs(k.offset - wide.offset) <= 1e-7 * std::abs(k.offset);
    });
    if (!seen) kept.push_back(wide);
  }
  return kept;
}

using Loop = std::vector<Vec3d>;

/// A square in the plane, large enough to contain the face.
Loop large_square(const WidePlane& plane, double half) {
  const Vec3d n = plane.normal, helper = std::abs(n.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d s = half * glm::normalize(glm::cross(helper, n)), t = glm::cross(n, s), centre = plane.offset * n;
  return {centre - s - t, centre + s - t, centre + s + t, centre - s + t};
}

/// Keeps the part behind the plane (Sutherland and Hodgman 1974).
Loop clip(const Loop& face, const WidePlane& plane) {
  Loop kept;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3d a = face[i], b = face[(i + 1) % face.size()];
    const double da = plane.height(a), db = plane.height(b);
    if (da <= 0) kept.push_back(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

double loop_area(const Loop& face) {
  Vec3d twice(0);
  for (std::size_t i = 1; i + 1 < face.size(); ++i) twice += glm::cross(face[i] - face[0], face[i + 1] - face[0]);
  return 0.5 * glm::length(twice);
}

std::vector<Vec3> without_repeats(const Loop& face, double tolerance) {
  std::vector<Vec3> vertices;
  for (std::size_t i = 0; i < face.size(); ++i)
    if (glm::length(face[i] - face[(i + 1) % face.size()]) > tolerance) vertices.emplace_back(face[i]);
  return vertices;
}

}  // namespace

std::vector<ConvexPolyhedron::Face> ConvexPolyhedron::make_faces(const std::vector<Plane>& planes) {
  const std::vector<WidePlane> sides = distinct(planes);
  double scale = 0;
  for (const WidePlane& side : sides) scale = std::max(scale, std::abs(side.offset));
  const double enormous = scale > 0 ? 1e6 * scale : 1;

  std::vector<Loop> loops;
  double total_area = 0, reach = 0;
  for (const WidePlane& side : sides) {
    Loop loop = large_square(side, enormous);
    for (const WidePlane& other : sides)
      if (&other != &side) loop = clip(loop, other);
    for (const Vec3d v : loop) reach = std::max(reach, glm::length(v));
    total_area += loop_area(loop);
    loops.push_back(std::move(loop));
  }
  if (reach > 0.1 * enormous) throw Error("the planes of a convex polyhedron do not enclose a finite body");

  std::vector<Face> faces;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (!(loop_area(loops[i]) > 1e-9 * total_area)) continue;
    const std::vector<Vec3> vertices = without_repeats(loops[i], 1e-9 * reach);
    if (vertices.size() >= 3) faces.push_back({sides[i].normal, sides[i].offset, Polygon(vertices)});
  }
  if (faces.size() < 4) throw Error("the planes of a convex polyhedron enclose nothing");
  return faces;
}

ConvexPolyhedron::ConvexPolyhedron(std::vector<Plane> planes)
    : faces_(make_faces(planes)), face_choice_([this] {
        std::vector<float> areas;
        for (const Face& face : faces_) areas.push_back(face.polygon.area());
        return DiscreteDistribution(areas);
      }()) {
  for (const Face& face : faces_) {
    bounds_.add(face.polygon.bounds());
    area_ += face.polygon.area();
  }
}

/// Enters at the last front-facing plane and leaves at the first back-facing one; hit if it enters before it leaves.
std::optional<ShapeHit> ConvexPolyhedron::intersect(const Ray& ray) const {
  const Vec3d o(ray.origin), d(ray.direction);
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  const Face *enter_face = nullptr, *leave_face = nullptr;
  for (const Face& face : faces_) {
    const double towards = glm::dot(face.normal, d), outside = glm::dot(face.normal, o) - face.offset;
    if (towards == 0 && outside > 0) return std::nullopt;
    const double t = -outside / towards;
    if (towards < 0 && t > enter) enter = t, enter_face = &face;
    if (towards > 0 && t < leave) leave = t, leave_face = &face;
  }
  if (!(enter <= leave) || !enter_face || !leave_face) return std::nullopt;
  const bool from_outside = static_cast<float>(enter) >= ray.t_min;
  const double t = from_outside ? enter : leave;
  const auto rounded = static_cast<float>(t);
  if (!(rounded >= ray.t_min && rounded <= ray.t_max)) return std::nullopt;
  return (from_outside ? enter_face : leave_face)->polygon.hit_at(rounded, Vec3(o + t * d));
}

ShapeSample ConvexPolyhedron::sample(Vec2 u) const {
  float within = 0;
  const Bin face = face_choice_.sample(u.x, within);
  return faces_[face.index].polygon.sample({within, u.y});
}

}  // namespace lambert
