#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

namespace lambert::denoise {

/// e^-x for x >= 0, to a relative error of 5e-5; x above 87, infinity too, counts as 87. Loops over it vectorise:
/// positive floats have the order of their bits, and a comparison of integers cannot trap, which would forbid it.
inline float exp_of_minus(float x) {
  const float t =
      std::bit_cast<float>(std::min(std::bit_cast<std::int32_t>(x), std::bit_cast<std::int32_t>(87.0f))) * -1.44269504f;
  const auto whole = static_cast<std::int32_t>(t);  // towards zero
  // 2^f for f in (-1, 0], by its Taylor series in f ln 2.
  const float f = (t - static_cast<float>(whole)) * 0.69314718f;
  const float series =
      1 + f * (1 + f * (0.5f + f * (1.6666667e-1f + f * (4.1666667e-2f + f * (8.3333333e-3f + f * 1.3888889e-3f)))));
  return series * std::bit_cast<float>((whole + 127) << 23);
}

}  // namespace lambert::denoise
