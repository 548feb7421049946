#include "lambert/image/tonemap/fast_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace lambert::tone {
namespace {

double relative_error(float got, double wanted) {
  return std::abs(static_cast<double>(got) - wanted) / std::abs(wanted);
}

TEST(FastMath, LogarithmKeepsItsBoundFromTheSmallestToTheLargest) {
  double worst = 0;
  const auto first = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::min());
  for (std::uint32_t bits = first; bits < 0x7f800000u; bits += 4099) {
    const auto x = std::bit_cast<float>(bits);
    if (x != 1.0f) worst = std::max(worst, relative_error(fast_log2(x), std::log2(static_cast<double>(x))));
  }
  // Near 1 all floats, where the logarithm is smallest.
  for (std::uint32_t bits = 0x3f7f0000u; bits < 0x3f810000u; ++bits) {
    const auto x = std::bit_cast<float>(bits);
    if (x != 1.0f) worst = std::max(worst, relative_error(fast_log2(x), std::log2(static_cast<double>(x))));
  }
  EXPECT_LT(worst, 4e-7);
  EXPECT_EQ(fast_log2(1.0f), 0.0f);
  EXPECT_EQ(fast_log2(0x1p-30f), -30.0f);
}

TEST(FastMath, ExponentialKeepsItsBound) {
  double worst = 0;
  for (float x = -126; x < 127; x += 0.00137f)
    worst = std::max(worst, relative_error(fast_exp2(x), std::exp2(static_cast<double>(x))));
  EXPECT_LT(worst, 4e-7);
  EXPECT_EQ(fast_exp2(0), 1.0f);
  EXPECT_EQ(fast_exp2(-1000), 0x1p-126f);
  EXPECT_EQ(fast_exp2(1000), 0x1p127f);
}

TEST(FastMath, PowerKeepsItsBound) {
  for (const float y : {-2.2f, -0.7f, 0.3f, 0.7f, 1.0f, 2.4f})
    for (float x = 1e-8f; x < 1e8f; x *= 1.013f) {
      const double wanted = std::pow(static_cast<double>(x), static_cast<double>(y));
      EXPECT_LT(relative_error(fast_pow(x, y), wanted), 4e-7 * (1 + std::abs(std::log2(wanted)))) << x << "^" << y;
    }
}

}  // namespace
}  // namespace lambert::tone
