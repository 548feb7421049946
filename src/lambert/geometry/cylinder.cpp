#include "lambert/geometry/azimuth.h"
#include "lambert/geometry/quadratic.h"
#include "lambert/geometry/shape.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

float body_area(const Cylinder& c) { return c.phi_max * c.radius * (c.z_max - c.z_min); }
float cap_area(const Cylinder& c) { return 0.5f * c.phi_max * sqr(c.radius); }

void keep_nearer(std::optional<ShapeHit>& nearest, const std::optional<ShapeHit>& hit) {
  if (hit && (!nearest || hit->t < nearest->t)) nearest = hit;
}

/// A ray that runs within the body's surface (parallel to the axis at the radius) has no root: it misses the body.
std::optional<ShapeHit> intersect_body(const Cylinder& c, const Ray& ray) {
  const double ox = static_cast<double>(ray.origin.x), oy = static_cast<double>(ray.origin.y);
  const double dx = static_cast<double>(ray.direction.x), dy = static_cast<double>(ray.direction.y);
  const double r = static_cast<double>(c.radius);
  const auto roots = solve_half_quadratic(dx * dx + dy * dy, ox * dx + oy * dy, ox * ox + oy * oy - r * r);
  if (!roots) return std::nullopt;
  for (const double root : {roots->near, roots->far}) {
    const auto t = static_cast<float>(root);
    if (!(t >= ray.t_min && t <= ray.t_max)) continue;
    Vec3 p = ray.at(t);
    const float phi = azimuth(p.x, p.y);
    if (p.z < c.z_min || p.z > c.z_max || phi > c.phi_max) continue;
    ShapeHit hit;
    hit.t = t;
    hit.normal = normalize(Vec3(p.x, p.y, 0));
    hit.uv = {std::min(phi / c.phi_max, 1.0f), std::clamp((p.z - c.z_min) / (c.z_max - c.z_min), 0.0f, 1.0f)};
    hit.dpdu = c.phi_max * Vec3(-p.y, p.x, 0);
    return hit;
  }
  return std::nullopt;
}

std::optional<ShapeHit> intersect_cap(const Cylinder& c, const Ray& ray, bool top) {
  const Disk disk{.height = top ? c.z_max : c.z_min, .radius = c.radius, .inner_radius = 0, .phi_max = c.phi_max};
  auto hit = disk.intersect(ray);
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

Bounds3 Cylinder::bounds() const { return {{-radius, -radius, z_min}, {radius, radius, z_max}}; }

float Cylinder::area() const { return body_area(*this) + (caps ? 2 * cap_area(*this) : 0); }

ShapeSample Cylinder::sample(Vec2 u) const {
  const float body_share = body_area(*this) / area();
  if (u.x < body_share) {
    const float v = std::min(u.x / body_share, one_minus_epsilon), phi = phi_max * u.y;
    const Vec3 normal(std::cos(phi), std::sin(phi), 0);
    return {Vec3(radius * normal.x, radius * normal.y, z_min + v * (z_max - z_min)), normal, {u.y, v}};
  }
  const float within = std::min(2 * (u.x - body_share) / (1 - body_share), 2 * one_minus_epsilon);
  const bool top = within >= 1;
  const Disk disk{.height = top ? z_max : z_min, .radius = radius, .inner_radius = 0, .phi_max = phi_max};
  ShapeSample s = disk.sample({std::min(top ? within - 1 : within, one_minus_epsilon), u.y});
  if (!top) s.normal = -s.normal;
  return s;
}

}  // namespace lambert
