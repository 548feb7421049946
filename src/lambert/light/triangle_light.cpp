#include "lambert/light/emission.h"
#include "lambert/sampling/spherical_triangle.h"
#include "lambert/sampling/warp.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

// Outside of these solid angles [sr] rounding spoils the spherical triangle: little is lost below by sampling its area.
constexpr float least_solid_angle = 3e-4f, greatest_solid_angle = 6.2f;

struct Plane {
  Vec3 normal;  // unit
  float area;
};
Plane plane_of(const std::array<Vec3, 3>& p) {
  const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
  const float doubled = length(n);
  return {n / doubled, 0.5f * doubled};
}

/// Whether the triangle looks so small that its solid angle hardly varies within it. Cheap, and the same for sample()
/// and pdf_omega().
bool looks_small(const TriangleLight& light, const Plane& plane, Vec3 from) {
  const Vec3 to_centre = (light.p[0] + light.p[1] + light.p[2]) / 3.0f - from;
  const float squared = length_squared(to_centre);
  const float about = plane.area * std::abs(dot(plane.normal, to_centre)) / (squared * std::sqrt(squared));
  return about < 0.01f && squared > 4 * plane.area;
}

std::optional<SphericalTriangle> seen_as_spherical(const TriangleLight& light, const Plane& plane, Vec3 from) {
  if (looks_small(light, plane, from)) return std::nullopt;
  const SphericalTriangle t(from, light.p);
  const bool good = t.solid_angle() >= least_solid_angle && t.solid_angle() <= greatest_solid_angle;
  return good ? std::optional(t) : std::nullopt;
}

/// Barycentric coordinates of the second and third vertex.
Vec2 barycentric(const std::array<Vec3, 3>& p, const Plane& plane, Vec3 at) {
  const float doubled = 2 * plane.area;
  return {dot(plane.normal, cross(at - p[0], p[2] - p[0])) / doubled,
          dot(plane.normal, cross(p[1] - p[0], at - p[0])) / doubled};
}

TextureCoordinates coordinates(const TriangleLight& light, Vec2 b, Vec3 position) {
  TextureCoordinates at;
  at.uv = at.uv1 = light.uv[0] + b.x * (light.uv[1] - light.uv[0]) + b.y * (light.uv[2] - light.uv[0]);
  at.position = position;
  return at;
}

}  // namespace

std::optional<LightSample> TriangleLight::sample(const LightContext& c, Vec3 from, Vec2 u) const {
  const Plane plane = plane_of(p);
  const float height = dot(plane.normal, from - p[0]);
  if (!emits(emission, height)) return std::nullopt;

  if (const auto seen = seen_as_spherical(*this, plane, from)) {
    LightSample s;
    s.wi = seen->sample(u);
    s.distance = -height / dot(plane.normal, s.wi);
    if (!(s.distance > 0) || std::isinf(s.distance)) return std::nullopt;  // rounding, seen edge on
    const Vec3 point = from + s.distance * s.wi;
    s.radiance = emitted_radiance(emission, c, coordinates(*this, barycentric(p, plane, point), point));
    s.pdf_omega = 1 / seen->solid_angle();
    s.normal = plane.normal;
    return s;
  }
  const Vec2 b = square_to_triangle(u);
  const Vec3 point = p[0] + b.x * (p[1] - p[0]) + b.y * (p[2] - p[0]);
  return area_light_sample(emission, c, from, point, plane.normal, coordinates(*this, b, point), 1 / plane.area);
}

float TriangleLight::pdf_omega(Vec3 from, Vec3 hit) const {
  const Plane plane = plane_of(p);
  if (const auto seen = seen_as_spherical(*this, plane, from)) return 1 / seen->solid_angle();
  return area_to_solid_angle(1 / plane.area, from, hit, plane.normal);
}

LightBounds TriangleLight::bounds(const LightContext& c) const {
  const Plane plane = plane_of(p);
  LightBounds b;
  for (const Vec3& vertex : p) b.box.add(vertex);
  b.axis = plane.normal;
  b.cos_theta_o = 1;
  b.two_sided = emission.two_sided;
  // The mean over the parallelogram stands for that over the triangle.
  b.intensity = plane.area * luminance(mean_emission(emission, c, uv[0], uv[1] - uv[0], uv[2] - uv[0]));
  b.power = pi * b.intensity * (emission.two_sided ? 2.0f : 1.0f);
  return b;
}

}  // namespace lambert
