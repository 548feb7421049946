#include "lambert/sampling/warp.h"

namespace lambert {
namespace {

Vec3 direction(float z, float sin_theta, float turn) {
  const float phi = 2 * pi * turn;
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), z};
}

}  // namespace

Vec2 square_to_uniform_disk_polar(Vec2 u) {
  const float r = std::sqrt(u.x), phi = 2 * pi * u.y;
  return {r * std::cos(phi), r * std::sin(phi)};
}
Vec2 uniform_disk_polar_to_square(Vec2 p) { return {dot(p, p), turn_of(p.x, p.y)}; }

Vec2 uniform_disk_concentric_to_square(Vec2 p) {
  const float r = std::sqrt(dot(p, p));
  if (r == 0) return Vec2(0.5f);
  const bool wide = std::abs(p.x) > std::abs(p.y);
  // With the sign of the dominant coordinate given to r, the angle is measured from that axis.
  const float signed_r = std::copysign(r, wide ? p.x : p.y);
  const float other = std::atan((wide ? p.y / p.x : p.x / p.y)) * (4 * inv_pi) * signed_r;
  const Vec2 s = wide ? Vec2(signed_r, other) : Vec2(other, signed_r);
  return 0.5f * (s + 1.0f);
}

Vec3 square_to_uniform_sphere(Vec2 u) { return direction(1 - 2 * u.x, 2 * safe_sqrt(u.x * (1 - u.x)), u.y); }
Vec2 uniform_sphere_to_square(Vec3 w) { return {0.5f * (1 - w.z), turn_of(w.x, w.y)}; }

Vec3 square_to_uniform_hemisphere(Vec2 u) { return direction(u.x, safe_sqrt(1 - u.x * u.x), u.y); }
Vec2 uniform_hemisphere_to_square(Vec3 w) { return {w.z, turn_of(w.x, w.y)}; }

Vec3 square_to_cosine_power(Vec2 u, float n) {
  const float z = std::pow(u.x, 1 / (n + 1));
  return direction(z, safe_sqrt(1 - z * z), u.y);
}
Vec2 cosine_power_to_square(Vec3 w, float n) { return {std::pow(std::max(0.0f, w.z), n + 1), turn_of(w.x, w.y)}; }
float cosine_power_pdf(Vec3 w, float n) { return w.z >= 0 ? (n + 1) * (0.5f * inv_pi) * std::pow(w.z, n) : 0; }

Vec3 square_to_uniform_cone(Vec2 u, float cos_theta_max) {
  // 1 - z in place of z: for narrow cones z rounds to 1.
  const float below_pole = u.x * (1 - cos_theta_max);
  return direction(1 - below_pole, safe_sqrt(below_pole * (2 - below_pole)), u.y);
}
Vec2 uniform_cone_to_square(Vec3 w, float cos_theta_max) {
  const float below_pole = (w.x * w.x + w.y * w.y) / (1 + w.z);
  return {below_pole / (1 - cos_theta_max), turn_of(w.x, w.y)};
}

float uniform_to_tent(float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - safe_sqrt(2 - 2 * u); }
float tent_to_uniform(float x) { return x < 0 ? 0.5f * (1 + x) * (1 + x) : 1 - 0.5f * (1 - x) * (1 - x); }

}  // namespace lambert
