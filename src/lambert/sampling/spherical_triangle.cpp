#include "lambert/sampling/spherical_triangle.h"

#include "lambert/sampling/warp.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// The angle between unit vectors, also where they are nearly parallel (Kahan).
float angle_between(Vec3 a, Vec3 b) { return 2 * std::atan2(length(a - b), length(a + b)); }

/// Unit vector along the part of v across unit n.
Vec3 across(Vec3 v, Vec3 n) {
  const Vec3 p = v - dot(v, n) * n;
  const float l = length(p);
  return l > 0 ? p / l : p;
}

}  // namespace

SphericalTriangle::SphericalTriangle(Vec3 from, const std::array<Vec3, 3>& v)
    : a_(normalize(v[0] - from)), b_(normalize(v[1] - from)), c_(normalize(v[2] - from)) {
  // Solid angle: tan(Ω/2) = a.(b x c) / (1 + a.b + b.c + c.a) (Van Oosterom and Strackee 1983).
  const float volume = std::abs(dot(a_, cross(b_, c_)));
  solid_angle_ = 2 * std::atan2(volume, 1 + dot(a_, b_) + dot(b_, c_) + dot(c_, a_));
  if (!(solid_angle_ > 0)) {
    solid_angle_ = 0;
    return;
  }
  alpha_ = angle_between(across(b_, a_), across(c_, a_));
  cos_alpha_ = std::cos(alpha_), sin_alpha_ = std::sin(alpha_);
  cos_c_ = dot(a_, b_);
}

Vec3 SphericalTriangle::sample(Vec2 u) const {
  // The vertex c' on the arc a-c for which the triangle a, b, c' has the area u.x Ω.
  const float area = u.x * solid_angle_;
  const float s = std::sin(area - alpha_), t = std::cos(area - alpha_);
  const float p = t - cos_alpha_, q = s + sin_alpha_ * cos_c_;
  const float numerator = (q * t - p * s) * cos_alpha_ - q, denominator = (q * s + p * t) * sin_alpha_;
  const float cos_b = denominator != 0 ? std::clamp(numerator / denominator, -1.0f, 1.0f) : 1.0f;
  const Vec3 c = cos_b * a_ + safe_sqrt(1 - cos_b * cos_b) * across(c_, a_);
  // Then heights along the arc b-c' are uniform.
  const float z = 1 - u.y * (1 - dot(c, b_));
  return normalize(z * b_ + safe_sqrt(1 - z * z) * across(c, b_));
}

Vec2 SphericalTriangle::to_square(Vec3 w) const {
  // c' is where the great circle through b and w meets the arc a-c.
  Vec3 c = cross(cross(b_, w), cross(c_, a_));
  const float l = length(c);
  if (!(l > 0)) return {1, 0};
  c /= dot(c, a_ + c_) < 0 ? -l : l;
  const float volume = std::abs(dot(a_, cross(b_, c)));
  const float area = 2 * std::atan2(volume, 1 + dot(a_, b_) + dot(b_, c) + dot(c, a_));
  const float reach = 1 - dot(c, b_);
  return {std::clamp(area / solid_angle_, 0.0f, 1.0f),
          reach > 0 ? std::clamp((1 - dot(w, b_)) / reach, 0.0f, 1.0f) : 0.0f};
}

}  // namespace lambert
