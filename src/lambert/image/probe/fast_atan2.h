#pragma once
#include <cmath>
#include <limits>
#include <numbers>

namespace lambert::probe {

/// atan2 to 3e-7 radians for finite arguments, 0 for (0, 0); no branches. atan t = t p(t²) on [0, 1], p of degree 8
/// with the least largest error (Lawson's iteration).
inline float fast_atan2(float y, float x) {
  constexpr float half_pi = 0.5f * std::numbers::pi_v<float>, whole_pi = std::numbers::pi_v<float>;
  const float ax = std::abs(x), ay = std::abs(y);
  const float high = ax > ay ? ax : ay, low = ax > ay ? ay : ax;
  const float t = low / (high + std::numeric_limits<float>::min()), z = t * t;
  float p = 0.002903552493080497f;
  p = p * z - 0.016283007338643074f;
  p = p * z + 0.043039366602897644f;
  p = p * z - 0.0753367617726326f;
  p = p * z + 0.10654677450656891f;
  p = p * z - 0.14207133650779724f;
  p = p * z + 0.19993053376674652f;
  p = p * z - 0.3333309292793274f;
  p = p * z + 1;
  float angle = t * p;
  // Of the eight octants: sums of numbers that are picked, not picked sums, which compilers leave in branches.
  const bool steep = ay > ax, behind = x < 0;
  angle = (steep ? half_pi : 0.0f) + (steep ? -angle : angle);
  angle = (behind ? whole_pi : 0.0f) + (behind ? -angle : angle);
  return std::copysign(angle, y);
}

}  // namespace lambert::probe
