#include "lambert/sampling/spherical_triangle.h"

#include "lambert/sampling/warp.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// Unit vector along the part of v across unit n.
Vec3 across(Vec3 v, Vec3 n) {
  const Vec3 p = v - dot(v, n) * n;
  const float l = length(p);
  return l > 0 ? p / l : p;
}

/// 1 - cos of the angle between unit vectors, also where they are nearly parallel.
float versine(Vec3 a, Vec3 b) { return 0.5f * length_squared(a - b); }

}  // namespace

// Solid angle: tan(Ω/2) = a.(b x c) / (1 + a.b + b.c + c.a) (Van Oosterom and Strackee 1983).
//
// Let e be the unit vector across a towards c. The triangle a, b, c' with c' = a cos θ + e sin θ on the arc from a to c
// has, by the same formula, the area A of tan(A/2) = V sin θ / ((1 + C) (1 + cos θ) + B sin θ), where C = a.b, B = e.b
// and V = a.(b x e). With h = tan(θ/2) = sin θ / (1 + cos θ):
//   tan(A/2) = V h / (1 + C + B h)   and   h = (1 + C) tan(A/2) / (V - B tan(A/2)).
// Arvo's formula gives cos θ, which has no digits left near a.
SphericalTriangle::SphericalTriangle(Vec3 from, const std::array<Vec3, 3>& v)
    : a_(normalize(v[0] - from)), b_(normalize(v[1] - from)), c_(normalize(v[2] - from)) {
  const float volume = std::abs(dot(a_, cross(b_ - a_, c_ - a_)));
  solid_angle_ = 2 * std::atan2(volume, 1 + dot(a_, b_) + dot(b_, c_) + dot(c_, a_));
  e_ = across(c_, a_);
  one_plus_ab_ = 1 + dot(a_, b_), eb_ = dot(e_, b_);
  volume_ = std::abs(dot(a_, cross(b_ - a_, e_)));
  if (!(solid_angle_ > 0 && volume_ > 0)) solid_angle_ = 0;
}

Vec3 SphericalTriangle::sample(Vec2 u) const {
  // The vertex c' on the arc a-c for which the triangle a, b, c' has the area u.x Ω.
  const float t = std::tan(0.5f * u.x * solid_angle_);
  const float h = one_plus_ab_ * t, scale = volume_ - eb_ * t;  // tan(θ/2) = h / scale
  const Vec3 c = ((scale * scale - h * h) * a_ + 2 * h * scale * e_) / (scale * scale + h * h);
  // Then heights along the arc b-c' are uniform.
  const float below = u.y * versine(c, b_);
  return normalize((1 - below) * b_ + safe_sqrt(below * (2 - below)) * across(c - b_, b_));
}

Vec2 SphericalTriangle::to_square(Vec3 w) const {
  // c' is where the great circle through b and w meets the arc a-c.
  Vec3 c = cross(cross(b_, w), cross(e_, a_));
  const float l = length(c);
  if (!(l > 0)) return {1, 0};
  c /= dot(c, a_ + c_) < 0 ? -l : l;
  const float h = dot(c, e_) / (1 + dot(c, a_));
  const float area = 2 * std::atan2(volume_ * h, one_plus_ab_ + eb_ * h);
  const float reach = versine(c, b_);
  return {std::clamp(area / solid_angle_, 0.0f, 1.0f), reach > 0 ? std::clamp(versine(w, b_) / reach, 0.0f, 1.0f) : 0};
}

}  // namespace lambert
