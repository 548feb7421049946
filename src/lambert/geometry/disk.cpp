#include "lambert/geometry/azimuth.h"
#include "lambert/geometry/shape.h"

#include <algorithm>
#include <cmath>

namespace lambert {

/// A ray in the disk's plane misses it: the disk has no thickness.
std::optional<ShapeHit> Disk::intersect(const Ray& ray) const {
  if (ray.direction.z == 0) return std::nullopt;
  const float t = (height - ray.origin.z) / ray.direction.z;
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;
  const Vec3 p = ray.at(t);
  const float squared = p.x * p.x + p.y * p.y;
  if (!(squared <= sqr(radius) && squared >= sqr(inner_radius))) return std::nullopt;
  const float phi = azimuth(p.x, p.y);
  if (phi > phi_max) return std::nullopt;
  ShapeHit hit;
  hit.t = t;
  hit.uv = {std::min(phi / phi_max, 1.0f), (radius - std::sqrt(squared)) / (radius - inner_radius)};
  hit.dpdu = squared > 0 ? phi_max * Vec3(-p.y, p.x, 0) : Vec3(0, 1, 0);
  return hit;
}

Bounds3 Disk::bounds() const { return {{-radius, -radius, height}, {radius, radius, height}}; }

float Disk::area() const { return 0.5f * phi_max * (sqr(radius) - sqr(inner_radius)); }

ShapeSample Disk::sample(Vec2 u) const {
  const float r = std::sqrt(sqr(inner_radius) + u.x * (sqr(radius) - sqr(inner_radius))), phi = phi_max * u.y;
  return {{r * std::cos(phi), r * std::sin(phi), height}, {0, 0, 1}, {u.y, (radius - r) / (radius - inner_radius)}};
}

}  // namespace lambert
