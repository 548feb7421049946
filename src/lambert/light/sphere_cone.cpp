#include "lambert/light/sphere_cone.h"

#include "lambert/base/frame.h"

#include <algorithm>
#include <cmath>

namespace lambert {

std::optional<SphereCone> SphereCone::from(Vec3 point, Vec3 centre, float radius) {
  const Vec3 axis = point - centre;
  const float squared = length_squared(axis), sin_squared_max = radius * radius / squared;
  if (!(sin_squared_max < 0.9999f)) return std::nullopt;
  return SphereCone(axis / std::sqrt(squared), sin_squared_max);
}

/// 1 - cos = sin² / (1 + cos), which does not cancel for small cones.
float SphereCone::one_minus_cos_max() const { return sin_squared_max_ / (1 + std::sqrt(1 - sin_squared_max_)); }

float SphereCone::pdf_omega() const { return 1 / (2 * pi * one_minus_cos_max()); }

/// With θ the angle from the cone's axis and r/d = sin θmax, the law of sines gives the angle α at the centre between
/// the axis and the point seen: cos α = sin²θ / sin θmax + cos θ √(1 - sin²θ / sin²θmax).
Vec3 SphereCone::sample_normal(Vec2 u) const {
  const float one_minus_cos = u.x * one_minus_cos_max();
  const float sin_squared = one_minus_cos * (2 - one_minus_cos);
  const float rest = std::max(0.0f, 1 - sin_squared / sin_squared_max_);
  const float cos_alpha =
      std::min(1.0f, sin_squared / std::sqrt(sin_squared_max_) + (1 - one_minus_cos) * std::sqrt(rest));
  const float sin_alpha = std::sqrt(1 - cos_alpha * cos_alpha), phi = 2 * pi * u.y;
  return Frame(axis_).to_world({sin_alpha * std::cos(phi), sin_alpha * std::sin(phi), cos_alpha});
}

}  // namespace lambert
