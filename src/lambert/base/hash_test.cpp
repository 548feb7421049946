#include "lambert/base/hash.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace lambert {
namespace {

TEST(MixBits, EachInputBitTurnsHalfOfTheOutputBits) {
  for (int bit = 0; bit < 64; ++bit) {
    double turned = 0;
    constexpr std::uint64_t count = 1000;
    for (std::uint64_t v = 1; v <= count; ++v)
      turned += std::popcount(mix_bits(v) ^ mix_bits(v ^ (std::uint64_t{1} << bit)));
    EXPECT_NEAR(turned / count, 32, 1.5) << "bit " << bit;
  }
}

TEST(HashValues, DependsOnEveryValueAndTheirOrder) {
  EXPECT_EQ(hash_values(1, 2.0f), hash_values(1, 2.0f));
  EXPECT_NE(hash_values(1, 2), hash_values(2, 1));
  EXPECT_NE(hash_values(1, 2), hash_values(1));
  EXPECT_NE(hash_values(0), hash_values(0, 0));
}

TEST(HashToFloat, IsUniformBelowOne) {
  EXPECT_LT(hash_to_float(~std::uint64_t{0}), 1);
  EXPECT_EQ(hash_to_float(0), 0);
  double sum = 0, squares = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<double>(hash_to_float(hash_values(i)));
    sum += x, squares += x * x;
  }
  EXPECT_NEAR(sum / count, 0.5, 4 * std::sqrt(1.0 / 12 / count));
  EXPECT_NEAR(squares / count, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / count));
}

}  // namespace
}  // namespace lambert
