#pragma once
/// Logarithm, power and exponential for loops over pixels: no branches, no calls, so that compilers vectorise the loop.

#include <bit>
#include <cstdint>

namespace lambert::tone {

/// log2 of a positive normal float, to a relative error below 4e-7 (also where the result is near 0).
inline float fast_log2(float x) {
  // x = 2^e m with m from sqrt(1/2) to sqrt(2), and log2 m = 2/ln 2 artanh s with s = (m-1)/(m+1), |s| < 0.172: the
  // series is cut after s^7, the next term is 8e-8 of the first.
  const auto bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t e = (bits - 0x3f3504f3) >> 23;
  const float m = std::bit_cast<float>(bits - e * (1 << 23));
  const float s = (m - 1.0f) / (m + 1.0f), q = s * s;
  return static_cast<float>(e) + s * (2.88539008f + q * (0.961796694f + q * (0.577078016f + q * 0.412198583f)));
}

/// `a` if `first`, else `b`, by masks: of conditional expressions on constants compilers make branches.
inline float chosen(bool first, float a, float b) {
  const std::int32_t mask = -static_cast<std::int32_t>(first);
  return std::bit_cast<float>((std::bit_cast<std::int32_t>(a) & mask) | (std::bit_cast<std::int32_t>(b) & ~mask));
}

inline float at_least(float v, float low) { return chosen(v > low, v, low); }
inline float at_most(float v, float high) { return chosen(v < high, v, high); }

/// 2^x to a relative error below 4e-7 for x from -126 to 127; beyond, the value at that end.
inline float fast_exp2(float x) {
  const float inside = at_most(at_least(x, -126.0f), 127.0f);
  // Adding 1.5 * 2^23 leaves the nearest whole number in the low bits.
  constexpr float shift = 0x1.8p23f;
  const float shifted = inside + shift;
  const float f = inside - (shifted - shift);
  const std::int32_t whole = std::bit_cast<std::int32_t>(shifted) - std::bit_cast<std::int32_t>(shift);
  // The power series, |f| at most 1/2; the next term is at most 1.2e-7.
  const float p =
      1.0f +
      f * (0.693147181f + f * (0.240226507f + f * (0.0555041087f +
                                                   f * (0.00961812911f + f * (0.00133335581f + f * 0.000154035304f)))));
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(p) + whole * (1 << 23));
}

/// x^y for positive normal x. The relative error is below 4e-7 (1 + |y log2 x|), so below 2e-6 where the result lies
/// between 1/16 and 16.
inline float fast_pow(float x, float y) { return fast_exp2(y * fast_log2(x)); }

inline float fast_log10(float x) { return 0.301029996f * fast_log2(x); }
inline float fast_exp10(float x) { return fast_exp2(3.32192809f * x); }

}  // namespace lambert::tone
