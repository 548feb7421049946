#include "lambert/light/light_bounds.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

struct Cone {
  Vec3 axis;
  float cos_theta;
};

float clamped_acos(float x) { return std::acos(std::clamp(x, -1.0f, 1.0f)); }
float sine(float cosine) { return std::sqrt(std::max(0.0f, 1 - cosine * cosine)); }

/// A cone about both, found by turning the wider one's axis towards the other's (ibid., algorithm 1).
Cone merge(Cone a, Cone b) {
  if (a.cos_theta > b.cos_theta) std::swap(a, b);
  if (a.cos_theta <= -1) return a;
  const float theta_a = clamped_acos(a.cos_theta), theta_b = clamped_acos(b.cos_theta);
  const float between = clamped_acos(dot(a.axis, b.axis));
  if (std::min(between + theta_b, pi) <= theta_a) return a;
  const float theta = 0.5f * (theta_a + between + theta_b);
  const Vec3 perpendicular = b.axis - dot(a.axis, b.axis) * a.axis;
  if (theta >= pi || length_squared(perpendicular) < 1e-12f) return {a.axis, -1};
  const float turn = theta - theta_a;
  const Vec3 axis = std::cos(turn) * a.axis + std::sin(turn) * normalize(perpendicular);
  return {normalize(axis), std::cos(theta)};
}

/// cos and sin of max(0, a - b), from those of a and b in [0, π].
struct CosSin {
  float cos, sin;
};
CosSin clamped_difference(CosSin a, CosSin b) {
  if (a.cos > b.cos) return {1, 0};
  return {a.cos * b.cos + a.sin * b.sin, a.sin * b.cos - a.cos * b.sin};
}

}  // namespace

LightBounds merge(const LightBounds& a, const LightBounds& b) {
  LightBounds m;
  m.box = a.box;
  m.box.add(b.box);
  const Cone cone = merge(Cone{a.axis, a.cos_theta_o}, Cone{b.axis, b.cos_theta_o});
  m.axis = cone.axis, m.cos_theta_o = cone.cos_theta;
  m.cos_theta_e = std::min(a.cos_theta_e, b.cos_theta_e);
  m.power = a.power + b.power;
  m.intensity = a.intensity + b.intensity;
  m.two_sided = a.two_sided || b.two_sided;
  return m;
}

float importance(const LightBounds& b, Vec3 point, Vec3 normal) {
  const Vec3 to_point = point - b.box.centre();
  const float squared = length_squared(to_point), radius_squared = 0.25f * length_squared(b.box.diagonal());
  // The mean of 1/d² over lights that fill a box evenly is, from its centre, about 6 / r².
  const float falloff = b.intensity / std::max({squared, radius_squared / 6, 1e-20f});
  if (squared <= radius_squared) return falloff;

  // θ_u: half angle of the sphere about the box, seen from the point.
  const float sin_squared_u = radius_squared / squared;
  const CosSin theta_u{std::sqrt(1 - sin_squared_u), std::sqrt(sin_squared_u)};
  const Vec3 away = to_point / std::sqrt(squared);

  float cos_w = dot(away, b.axis);
  if (b.two_sided) cos_w = std::abs(cos_w);
  const CosSin beyond_normals = clamped_difference({cos_w, sine(cos_w)}, {b.cos_theta_o, sine(b.cos_theta_o)});
  const float cos_light = clamped_difference(beyond_normals, theta_u).cos;
  if (cos_light <= b.cos_theta_e) return 0;
  if (normal == Vec3(0)) return falloff * cos_light;

  const float cos_i = std::abs(dot(away, normal));
  return falloff * cos_light * clamped_difference({cos_i, sine(cos_i)}, theta_u).cos;
}

float orientation_measure(const LightBounds& b) {
  const float theta_o = clamped_acos(b.cos_theta_o), theta_e = clamped_acos(b.cos_theta_e);
  const float theta_w = std::min(theta_o + theta_e, pi);
  const float sin_o = std::sin(theta_o), cos_o = std::cos(theta_o);
  return 2 * pi * (1 - cos_o) +
         0.5f * pi * (2 * theta_w * sin_o - std::cos(theta_o - 2 * theta_w) - 2 * theta_o * sin_o + cos_o);
}

}  // namespace lambert
