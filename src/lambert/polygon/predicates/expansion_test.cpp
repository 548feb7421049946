#include "lambert/polygon/predicates/expansion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lambert::polygon {
namespace {

using Integer = __int128;

int sign_of(Integer i) { return (i > 0) - (i < 0); }

/// Integers of at most 53 significant bits, and sums that nearly cancel.
std::int64_t some_integer(std::mt19937_64& random, int bits) {
  const auto magnitude = static_cast<std::int64_t>(random() >> (64 - 1 - random() % static_cast<unsigned>(bits)) >> 1);
  return random() % 2 ? magnitude : -magnitude;
}

template <std::size_t n>
Integer value_of(const Expansion<n>& e) {
  Integer sum = 0;
  for (std::size_t i = 0; i < e.size(); ++i) sum += static_cast<Integer>(e[i]);
  return sum;
}

/// Smallest first, no zero, and no component reaches into the bits of the one before.
template <std::size_t n>
void expect_well_formed(const Expansion<n>& e) {
  for (std::size_t i = 0; i < e.size(); ++i) ASSERT_NE(e[i], 0);
  for (std::size_t i = 1; i < e.size(); ++i) {
    const double unit = std::ldexp(1, std::ilogb(e[i - 1]) + 1);
    ASSERT_EQ(std::fmod(e[i], unit), 0) << "component " << i << " overlaps the one below";
  }
}

TEST(TwoSum, ErrorAndValueAreTheSum) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i) {
    const std::int64_t a = some_integer(random, 52), b = some_integer(random, 20);
    const double high = std::ldexp(static_cast<double>(a), 40);
    const RoundedSum sum = two_sum(high, static_cast<double>(b));
    EXPECT_TRUE(static_cast<Integer>(sum.value) + static_cast<Integer>(sum.error) ==
                (static_cast<Integer>(a) << 40) + b);
    EXPECT_EQ(sum.value, high + static_cast<double>(b));
  }
}

TEST(TwoProduct, ErrorAndValueAreTheProduct) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 10000; ++i) {
    const std::int64_t a = some_integer(random, 53), b = some_integer(random, 53);
    const RoundedSum product = two_product(static_cast<double>(a), static_cast<double>(b));
    EXPECT_TRUE(static_cast<Integer>(product.value) + static_cast<Integer>(product.error) ==
                static_cast<Integer>(a) * b);
  }
}

TEST(Expansion, SumsAndProductsOfIntegersAreExact) {
  std::mt19937_64 random(3);
  int cancelled = 0;
  for (int i = 0; i < 20000; ++i) {
    std::int64_t a[4], b[4];
    for (int k = 0; k < 4; ++k) a[k] = some_integer(random, 50), b[k] = some_integer(random, 50);
    if (i % 3 == 0) b[0] = a[0], b[1] = a[1] + static_cast<std::int64_t>(random() % 3) - 1;
    const auto sum_of = [](std::int64_t p, std::int64_t q) {
      return Expansion<2>(two_sum(static_cast<double>(p), static_cast<double>(q)));
    };
    const auto left = sum_of(a[0], a[2]) * sum_of(b[1], b[3]), right = sum_of(b[0], a[2]) * sum_of(a[1], b[3]);
    const auto difference = left - right;
    const Integer exact = (static_cast<Integer>(a[0]) + a[2]) * (static_cast<Integer>(b[1]) + b[3]) -
                          (static_cast<Integer>(b[0]) + a[2]) * (static_cast<Integer>(a[1]) + b[3]);
    ASSERT_TRUE(value_of(difference) == exact);
    EXPECT_EQ(difference.sign(), sign_of(exact));
    EXPECT_EQ((-difference).sign(), -sign_of(exact));
    expect_well_formed(left);
    expect_well_formed(difference);
    const double rounded = static_cast<double>(exact);
    EXPECT_NEAR(difference.estimate(), rounded, 0x1p-52 * std::abs(rounded));
    cancelled += exact == 0;
  }
  EXPECT_GT(cancelled, 500) << "the test never met an exact zero";
}

TEST(Expansion, KeepsWhatADoubleCannot) {
  const Expansion<2> one_and_a_bit(two_sum(1, 0x1p-200));
  const auto square = one_and_a_bit * one_and_a_bit;  // 1 + 2^-199 + 2^-400
  const auto rest = square - Expansion<2>(two_sum(1, 0x1p-199));
  EXPECT_EQ(rest.size(), 1u);
  EXPECT_EQ(rest.estimate(), 0x1p-400);
  EXPECT_EQ((rest - rest).sign(), 0);
  EXPECT_EQ((rest - rest).size(), 0u);
}

}  // namespace
}  // namespace lambert::polygon
