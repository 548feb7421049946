#include "lambert/geometry/azimuth.h"
#include "lambert/geometry/shape.h"

#include <algorithm>
#include <cmath>

namespace lambert {

/// A ray in the disk's plane misses it: the disk has no thickness.
std::optional<ShapeHit> Disk::intersect(const Ray& ray) const {
  if (ray.direction.z == 0) return std::nullopt;
  const double t =
      (static_cast<double>(height) - static_cast<double>(ray.origin.z)) / static_cast<double>(ray.direction.z);
  ShapeHit hit;
  hit.t = static_cast<float>(t);
  if (!(hit.t >= ray.t_min && hit.t <= ray.t_max)) return std::nullopt;
  hit.position = Vec3(Vec3d(ray.origin) + t * Vec3d(ray.direction));
  hit.position.z = height;
  const float r = std::hypot(hit.position.x, hit.position.y), phi = azimuth(hit.position.x, hit.position.y);
  if (!(r <= radius && r >= inner_radius && phi <= phi_max)) return std::nullopt;
  hit.uv = {std::min(phi / phi_max, 1.0f), (radius - r) / (radius - inner_radius)};
  hit.dpdu = azimuth_derivative(Vec3(hit.position.x, hit.position.y, 0), phi_max);
  return hit;
}

Bounds3 Disk::bounds() const { return sector_bounds(inner_radius, radius, phi_max, height, height); }

float Disk::area() const { return 0.5f * phi_max * (radius - inner_radius) * (radius + inner_radius); }

ShapeSample Disk::sample(Vec2 u) const {
  const float squared = sqr(inner_radius) + u.x * (radius - inner_radius) * (radius + inner_radius);
  const float r = std::clamp(std::sqrt(squared), inner_radius, radius), phi = phi_max * u.y;
  return {{r * std::cos(phi), r * std::sin(phi), height}, {0, 0, 1}, {u.y, (radius - r) / (radius - inner_radius)}};
}

}  // namespace lambert
