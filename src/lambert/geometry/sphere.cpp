#include "lambert/geometry/azimuth.h"
#include "lambert/geometry/quadratic.h"
#include "lambert/geometry/shape.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

float lower(const Sphere& s) { return std::clamp(s.z_min, -s.radius, s.radius); }
float upper(const Sphere& s) { return std::clamp(s.z_max, -s.radius, s.radius); }

/// θ is measured from +z; v runs from z_min (0) to z_max (1) in θ.
float polar_angle(const Sphere& s, float z) { return std::acos(std::clamp(z / s.radius, -1.0f, 1.0f)); }

float v_at(const Sphere& s, float z) {
  const float bottom = polar_angle(s, lower(s)), top = polar_angle(s, upper(s));
  return std::clamp((polar_angle(s, z) - bottom) / (top - bottom), 0.0f, 1.0f);
}

/// Distance from the axis at height z.
float ring_radius(const Sphere& s, float z) { return std::sqrt(std::max(0.0f, (s.radius - z) * (s.radius + z))); }

}  // namespace

std::optional<ShapeHit> Sphere::intersect(const Ray& ray) const {
  const Vec3d o(ray.origin), d(ray.direction);
  const double a = glm::dot(d, d), b = glm::dot(o, d), r = static_cast<double>(radius);
  // The discriminant from the distance of the ray to the centre: stable for far and for small spheres (Haines et al.,
  // "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7). In double on top of that.
  const Vec3d nearest = o - (b / a) * d;
  const auto roots = solve_half_quadratic(a, b, glm::dot(o, o) - r * r, a * (r * r - glm::dot(nearest, nearest)));
  if (!roots) return std::nullopt;
  for (const double t : {roots->near, roots->far}) {
    ShapeHit hit;
    hit.t = static_cast<float>(t);
    if (!(hit.t >= ray.t_min && hit.t <= ray.t_max)) continue;
    const Vec3d p = o + t * d;
    hit.position = Vec3(p * (r / glm::length(p)));
    const float phi = azimuth(hit.position.x, hit.position.y);
    if (!is_full() && (hit.position.z < z_min || hit.position.z > z_max || phi > phi_max)) continue;
    hit.normal = hit.position / radius;
    hit.uv = {std::min(phi / phi_max, 1.0f), v_at(*this, hit.position.z)};
    hit.dpdu = azimuth_derivative(hit.position, phi_max);
    return hit;
  }
  return std::nullopt;
}

Bounds3 Sphere::bounds() const {
  const float low = lower(*this), high = upper(*this), a = ring_radius(*this, low), b = ring_radius(*this, high);
  const float widest = low <= 0 && high >= 0 ? radius : std::max(a, b);
  return sector_bounds(std::min(a, b), widest, phi_max, low, high);
}

/// Archimedes: a zone's area is that of the cylinder about it.
float Sphere::area() const { return phi_max * radius * (upper(*this) - lower(*this)); }

ShapeSample Sphere::sample(Vec2 u) const {
  const float z = lower(*this) + u.x * (upper(*this) - lower(*this)), phi = phi_max * u.y;
  const float ring = ring_radius(*this, z);
  const Vec3 position(ring * std::cos(phi), ring * std::sin(phi), z);
  return {position, position / radius, {u.y, v_at(*this, z)}};
}

}  // namespace lambert
