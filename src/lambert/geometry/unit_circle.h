#pragma once
#include "lambert/base/vec.h"

#include <cmath>
#include <numbers>

namespace lambert {

/// Cosine and sine of `turns` revolutions; exact at quarters, so that what closes meets.
inline Vec2d unit_circle(double turns) {
  const double angle = 2 * std::numbers::pi * turns, c = std::cos(angle), s = std::sin(angle);
  constexpr double rounding = 1e-12;
  return {std::abs(c) < rounding ? 0 : c, std::abs(s) < rounding ? 0 : s};
}

}  // namespace lambert
