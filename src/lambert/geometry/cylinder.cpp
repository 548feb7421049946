#include "lambert/geometry/azimuth.h"
#include "lambert/geometry/quadratic.h"
#include "lambert/geometry/shape.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

float body_area(const Cylinder& c) { return c.phi_max * c.radius * (c.z_max - c.z_min); }

Disk cap(const Cylinder& c, bool top) {
  return {.height = top ? c.z_max : c.z_min, .radius = c.radius, .inner_radius = 0, .phi_max = c.phi_max};
}

void keep_nearer(std::optional<ShapeHit>& nearest, const std::optional<ShapeHit>& hit) {
  if (hit && (!nearest || hit->t < nearest->t)) nearest = hit;
}

/// A ray that runs within the body's surface (parallel to the axis at the radius) has no root: it misses the body.
std::optional<ShapeHit> intersect_body(const Cylinder& c, const Ray& ray) {
  const Vec3d o(ray.origin), d(ray.direction);
  const double r = static_cast<double>(c.radius);
  const double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y;
  // As for the sphere: from the distance of the ray to the axis.
  const double nx = o.x - b / a * d.x, ny = o.y - b / a * d.y;
  const auto roots = solve_half_quadratic(a, b, o.x * o.x + o.y * o.y - r * r, a * (r * r - (nx * nx + ny * ny)));
  if (!roots) return std::nullopt;
  for (const double t : {roots->near, roots->far}) {
    ShapeHit hit;
    hit.t = static_cast<float>(t);
    if (!(hit.t >= ray.t_min && hit.t <= ray.t_max)) continue;
    const Vec3d p = o + t * d;
    hit.position = Vec3(Vec3d(p.x, p.y, 0) * (r / std::hypot(p.x, p.y)));
    hit.position.z = static_cast<float>(p.z);
    const float phi = azimuth(hit.position.x, hit.position.y);
    if (!(hit.position.z >= c.z_min && hit.position.z <= c.z_max && phi <= c.phi_max)) continue;
    hit.normal = Vec3(hit.position.x, hit.position.y, 0) / c.radius;
    hit.uv = {std::min(phi / c.phi_max, 1.0f), (hit.position.z - c.z_min) / (c.z_max - c.z_min)};
    hit.dpdu = azimuth_derivative(hit.position, c.phi_max);
    return hit;
  }
  return std::nullopt;
}

std::optional<ShapeHit> intersect_cap(const Cylinder& c, const Ray& ray, bool top) {
  auto hit = cap(c, top).intersect(ray);
  if (hit && !top) hit->normal = -hit->normal;
  return hit;
}

}  // namespace

std::optional<ShapeHit> Cylinder::intersect(const Ray& ray) const {
  std::optional<ShapeHit> nearest = intersect_body(*this, ray);
  if (!caps) return nearest;
  keep_nearer(nearest, intersect_cap(*this, ray, false));
  keep_nearer(nearest, intersect_cap(*this, ray, true));
  return nearest;
}

Bounds3 Cylinder::bounds() const { return sector_bounds(caps ? 0 : radius, radius, phi_max, z_min, z_max); }

float Cylinder::area() const { return body_area(*this) + (caps ? 2 * cap(*this, true).area() : 0); }

ShapeSample Cylinder::sample(Vec2 u) const {
  const float body_share = caps ? body_area(*this) / area() : 1;
  if (u.x < body_share) {
    const float v = std::min(u.x / body_share, one_minus_epsilon), phi = phi_max * u.y;
    const Vec3 normal(std::cos(phi), std::sin(phi), 0);
    return {Vec3(radius * normal.x, radius * normal.y, z_min + v * (z_max - z_min)), normal, {u.y, v}};
  }
  const float within = 2 * (u.x - body_share) / (1 - body_share);
  const bool top = within >= 1;
  ShapeSample s = cap(*this, top).sample({std::min(top ? within - 1 : within, one_minus_epsilon), u.y});
  if (!top) s.normal = -s.normal;
  return s;
}

}  // namespace lambert
