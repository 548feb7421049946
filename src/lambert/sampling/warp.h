#pragma once
/// Warps of the unit square, in triples: forward (square to domain), inverse (domain to square) and density on the
/// domain (per unit area for plane domains, per steradian for directions). Directions are unit, the axis is +z.

#include "lambert/base/vec.h"

#include <algorithm>
#include <cmath>

namespace lambert {

inline float safe_sqrt(float x) { return std::sqrt(std::max(0.0f, x)); }

/// The angle of (x, y) over 2π, in [0,1).
inline float turn_of(float x, float y) {
  const float turn = std::atan2(y, x) * (0.5f * inv_pi);
  return std::min(turn < 0 ? turn + 1 : turn, one_minus_epsilon);
}

// Unit disk, polar: r = sqrt(u), φ = 2π v (row PT-17).
Vec2 square_to_uniform_disk_polar(Vec2 u);
Vec2 uniform_disk_polar_to_square(Vec2 p);
inline float uniform_disk_pdf(Vec2 p) { return dot(p, p) <= 1 ? inv_pi : 0; }

/// Sine and cosine of x in [-π/4, π/4], within 2^-23: truncated series with economised last terms.
inline Vec2 cos_sin_octant(float x) {
  const float x2 = x * x;
  const float cos = 1 + x2 * (-0.5f + x2 * (0.041666646f + x2 * (-0.0013887316f + x2 * 2.4433157e-5f)));
  const float sin = x * (1 + x2 * (-0.16666655f + x2 * (0.0083321609f + x2 * -0.00019515296f)));
  return {cos, sin};
}

/// Unit disk, concentric: keeps nearby points near (Shirley and Chiu 1997).
inline Vec2 square_to_uniform_disk_concentric(Vec2 u) {
  const float x = 2 * u.x - 1, y = 2 * u.y - 1;
  if (x == 0 && y == 0) return Vec2(0);
  const bool wide = x * x > y * y;
  const float r = wide ? x : y;
  const Vec2 p = r * cos_sin_octant((pi / 4) * (wide ? y / x : x / y));
  return wide ? p : Vec2(p.y, p.x);
}
Vec2 uniform_disk_concentric_to_square(Vec2 p);

// Unit sphere: z = 1 - 2u (row PT-19).
Vec3 square_to_uniform_sphere(Vec2 u);
Vec2 uniform_sphere_to_square(Vec3 w);
inline float uniform_sphere_pdf() { return 0.25f * inv_pi; }

// Upper hemisphere, uniform: z = u (row PT-20).
Vec3 square_to_uniform_hemisphere(Vec2 u);
Vec2 uniform_hemisphere_to_square(Vec3 w);
inline float uniform_hemisphere_pdf(Vec3 w) { return w.z >= 0 ? 0.5f * inv_pi : 0; }

/// Upper hemisphere by cos θ / π: the concentric disk lifted (Malley's method).
inline Vec3 square_to_cosine_hemisphere(Vec2 u) {
  const Vec2 p = square_to_uniform_disk_concentric(u);
  return {p.x, p.y, safe_sqrt(1 - dot(p, p))};
}
inline Vec2 cosine_hemisphere_to_square(Vec3 w) { return uniform_disk_concentric_to_square({w.x, w.y}); }
inline float cosine_hemisphere_pdf(Vec3 w) { return std::max(0.0f, w.z) * inv_pi; }

// Upper hemisphere by (n + 1) cosⁿ θ / 2π, n >= 0: z = u^(1/(n+1)) (row PT-15).
Vec3 square_to_cosine_power(Vec2 u, float n);
Vec2 cosine_power_to_square(Vec3 w, float n);
float cosine_power_pdf(Vec3 w, float n);

// Cone about +z of half angle acos(cos_theta_max), uniform.
Vec3 square_to_uniform_cone(Vec2 u, float cos_theta_max);
Vec2 uniform_cone_to_square(Vec3 w, float cos_theta_max);
inline float uniform_cone_pdf(Vec3 w, float cos_theta_max) {
  return w.z >= cos_theta_max ? 1 / (2 * pi * (1 - cos_theta_max)) : 0;
}

/// Barycentric coordinates (of the 2nd and 3rd vertex), uniform over a triangle; density 2 over them. The square is
/// folded along its diagonal by a low-distortion map (Heitz 2019).
inline Vec2 square_to_triangle(Vec2 u) {
  if (u.x < u.y) {
    const float a = 0.5f * u.x;
    return {a, u.y - a};
  }
  const float b = 0.5f * u.y;
  return {u.x - b, b};
}
inline Vec2 triangle_to_square(Vec2 b) { return b.x < b.y ? Vec2(2 * b.x, b.x + b.y) : Vec2(b.x + b.y, 2 * b.y); }
inline float triangle_pdf() { return 2; }

// [-1,1] by 1 - |x| (the tent).
float uniform_to_tent(float u);
float tent_to_uniform(float x);
inline float tent_pdf(float x) { return std::max(0.0f, 1 - std::abs(x)); }

}  // namespace lambert
