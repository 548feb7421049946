#include "lambert/sampling/sobol.h"

#include "lambert/base/hash.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace lambert {
namespace {

/// The second column of Sobol's matrices by its recurrence (Joe and Kuo 2008; polynomial x + 1, m = 1):
/// v_k = v_(k-1) xor (v_(k-1) >> 1).
std::uint32_t second_dimension(std::uint32_t i) {
  std::uint32_t x = 0, v = 1u << 31;
  for (; i; i >>= 1, v ^= v >> 1)
    if (i & 1) x ^= v;
  return x;
}

TEST(Sobol, ReversesBits) {
  EXPECT_EQ(reverse_bits(1), 0x80000000u);
  EXPECT_EQ(reverse_bits(0x0000beefu), 0xf77d0000u);
  for (std::uint32_t i = 0; i < 100; ++i) {
    const auto x = static_cast<std::uint32_t>(mix_bits(i));
    EXPECT_EQ(reverse_bits(reverse_bits(x)), x);
  }
}

TEST(Sobol, FirstPointsAreTheTextbooks) {
  const std::array<double, 8> y = {0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875};
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(reverse_bits(pascal_bits(i)) * 0x1p-32, y[i]);
}

TEST(Sobol, SecondDimensionObeysTheRecurrence) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto x = static_cast<std::uint32_t>(mix_bits(i));
    EXPECT_EQ(reverse_bits(pascal_bits(x)), second_dimension(x));
  }
}

TEST(Sobol, ScramblingIsAPermutation) {
  std::vector<bool> seen(1 << 16);
  for (std::uint32_t i = 0; i < seen.size(); ++i) {
    const std::uint32_t low = laine_karras(i, 0x9e3779b9u) & 0xffff;
    EXPECT_FALSE(seen[low]) << i;
    seen[low] = true;
  }
}

// What makes it Owen scrambling of reversed bits: flipping a bit leaves all lower ones as they are, and flips its own.
TEST(Sobol, ScrambledBitsDependOnLowerOnesOnly) {
  for (std::uint32_t i = 0; i < 200; ++i) {
    const std::uint64_t h = mix_bits(i + 1);
    const auto x = static_cast<std::uint32_t>(h), seed = static_cast<std::uint32_t>(h >> 32);
    for (int bit = 0; bit < 32; ++bit) {
      const std::uint32_t difference = laine_karras(x, seed) ^ laine_karras(x ^ (1u << bit), seed);
      EXPECT_EQ(difference & ((2u << bit) - 1), 1u << bit) << "bit " << bit;
    }
  }
}

// Every bit below the top must be flipped for about half of the seeds, whatever the bits before it are.
TEST(Sobol, SeedsFlipEveryBit) {
  for (int bit = 0; bit < 32; ++bit) {
    int flips = 0;
    for (std::uint32_t s = 0; s < 4000; ++s) {
      const std::uint64_t h = mix_bits(s + 77);
      const auto x = static_cast<std::uint32_t>(h), seed = static_cast<std::uint32_t>(h >> 32);
      flips += static_cast<int>((laine_karras(x, seed) ^ x) >> bit & 1);
    }
    EXPECT_NEAR(flips, 2000, 5 * 32) << "bit " << bit;  // five standard deviations
  }
}

}  // namespace
}  // namespace lambert
