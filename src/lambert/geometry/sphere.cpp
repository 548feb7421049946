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

}  // namespace

std::optional<ShapeHit> Sphere::intersect(const Ray& ray) const {
  const Vec3d o(ray.origin), d(ray.direction);
  const double a = glm::dot(d, d);
  // The discriminant from the distance of the ray to the centre: stable for far and for small spheres (Haines et al.,
  // "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7). In double on top of that.
  const double b = glm::dot(o, d);
  const Vec3d nearest = o - (b / a) * d;
  const double r = static_cast<double>(radius);
  const double discriminant = a * (r * r - glm::dot(nearest, nearest));
  if (!(discriminant >= 0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  const double q = -(b + std::copysign(root, b));
  const double c = glm::dot(o, o) - r * r;
  double t[2] = {q / a, q != 0 ? c / q : q / a};
  if (t[0] > t[1]) std::swap(t[0], t[1]);

  for (const double candidate : t) {
    if (!(candidate >= static_cast<double>(ray.t_min) && candidate <= static_cast<double>(ray.t_max))) continue;
    Vec3d p = o + candidate * d;
    p *= r / glm::length(p);
    const Vec3 point(p);
    const float phi = azimuth(point.x, point.y);
    if (!is_full() && (point.z < z_min || point.z > z_max || phi > phi_max)) continue;

    ShapeHit hit;
    hit.t = static_cast<float>(candidate);
    hit.normal = point / radius;
    const float bottom = polar_angle(*this, lower(*this)), top = polar_angle(*this, upper(*this));
    hit.uv = {std::min(phi / phi_max, 1.0f),
              std::clamp((polar_angle(*this, point.z) - bottom) / (top - bottom), 0.0f, 1.0f)};
    hit.dpdu = phi_max * Vec3(-point.y, point.x, 0);
    return hit;
  }
  return std::nullopt;
}

Bounds3 Sphere::bounds() const { return {{-radius, -radius, lower(*this)}, {radius, radius, upper(*this)}}; }

/// Archimedes: a zone's area is that of the cylinder about it.
float Sphere::area() const { return phi_max * radius * (upper(*this) - lower(*this)); }

ShapeSample Sphere::sample(Vec2 u) const {
  const float z = lower(*this) + u.x * (upper(*this) - lower(*this)), phi = phi_max * u.y;
  const float ring = std::sqrt(std::max(0.0f, (radius - z) * (radius + z)));
  ShapeSample s;
  s.position = {ring * std::cos(phi), ring * std::sin(phi), z};
  s.normal = s.position / radius;
  const float bottom = polar_angle(*this, lower(*this)), top = polar_angle(*this, upper(*this));
  s.uv = {u.y, (polar_angle(*this, z) - bottom) / (top - bottom)};
  return s;
}

}  // namespace lambert
