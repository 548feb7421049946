#include "lambert/geometry/ray_tests.h"

#include <cmath>

namespace lambert {
namespace {

PlaneMeeting meeting(double at_start, double change) {
  if (change != 0) return -at_start / change;
  return at_start == 0 ? PlaneMeeting(LiesInPlane{}) : PlaneMeeting(NoMeeting{});
}

double determinant(double a, double b, double c, double d) { return a * d - b * c; }

}  // namespace

PlaneMeeting line_plane(Vec3d p1, Vec3d p2, double a, double b, double c, double d) {
  const Vec3d n(a, b, c);
  return meeting(glm::dot(n, p1) + d, glm::dot(n, p2 - p1));
}

PlaneMeeting line_plane(Vec3d p1, Vec3d p2, Vec3d s, Vec3d n) {
  return meeting(glm::dot(n, p1 - s), glm::dot(n, p2 - p1));
}

bool on_ray(double t) { return t >= 0; }
bool on_segment(double t) { return t >= 0 && t <= 1; }

double triangle_area(Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d u = b - a, v = c - a;
  const double yz = determinant(u.y, u.z, v.y, v.z), zx = determinant(u.z, u.x, v.z, v.x),
               xy = determinant(u.x, u.y, v.x, v.y);
  return 0.5 * std::sqrt(yz * yz + zx * zx + xy * xy);
}

Vec3d barycentric_by_areas(Vec3d p, Vec3d a, Vec3d b, Vec3d c) {
  return Vec3d(triangle_area(p, b, c), triangle_area(a, p, c), triangle_area(a, b, p)) / triangle_area(a, b, c);
}

bool inside_by_areas(Vec3d p, Vec3d a, Vec3d b, Vec3d c, double tolerance) {
  const Vec3d w = barycentric_by_areas(p, a, b, c);
  return w.x + w.y + w.z <= 1 + tolerance;
}

std::optional<double> ray_triangle(Vec3d origin, Vec3d direction, Vec3d a, Vec3d b, Vec3d c) {
  const PlaneMeeting met = line_plane(origin, origin + direction, a, glm::cross(b - a, c - a));
  const double* t = std::get_if<double>(&met);
  if (!t || !on_ray(*t) || !inside_by_areas(origin + *t * direction, a, b, c)) return std::nullopt;
  return *t;
}

bool inside_projected_polygon(Vec3d p, std::span<const Vec3> polygon, int drop_axis) {
  const int a = (drop_axis + 1) % 3, b = (drop_axis + 2) % 3;
  bool inside = false;
  Vec3d w(polygon.back());
  for (const Vec3& corner : polygon) {
    const Vec3d v(corner);
    if ((v[b] > p[b]) != (w[b] > p[b]) && p[a] < v[a] + (p[b] - v[b]) / (w[b] - v[b]) * (w[a] - v[a])) inside = !inside;
    w = v;
  }
  return inside;
}

}  // namespace lambert
