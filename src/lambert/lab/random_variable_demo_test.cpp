#include "lambert/lab/demo_test_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambert::lab {
namespace {

using std::numbers::pi;

// rows: PT-07
TEST(RandomVariableDemo, AreaDifferenceAndShareAreTheSameProbability) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Shown shown = show_random_variable({.seed = seed});
    EXPECT_NEAR(fact(shown, "integral of the density"), 1, 1e-7);
    // 3/4 - 2/8 - (3/25 - 2/125)
    EXPECT_NEAR(fact(shown, "the same, difference of the distribution"), 0.396, 1e-12);
    EXPECT_NEAR(fact(shown, "probability of 0.2 to 0.5, area under the density"), 0.396, 1e-7);
    EXPECT_NEAR(fact(shown, "the same, share of the samples"), 0.396, 4 * std::sqrt(0.396 * 0.604 / 4000));
  }
}

// rows: PT-08
TEST(RandomVariableDemo, TheCosineHasMeanZeroWithinItsDeviation) {
  const Shown shown = show_random_variable({});
  EXPECT_NEAR(fact(shown, "mean of cos X"), 0, 1e-12);
  EXPECT_NEAR(fact(shown, "mean of cos X, 65536 samples"), 0, 4 * std::sqrt(0.5) / 256);
  // 95.45 % of a normal distribution; the share of 1000 has a deviation of 0.66 %.
  EXPECT_NEAR(fact(shown, "share of 1000 means within 2 deviations"), 0.9545, 0.025);
}

// rows: PT-08
TEST(RandomVariableDemo, MeansAddUpWhereVariancesDoNot) {
  const Shown shown = show_random_variable({});
  const double mean = 3 * pi / 2 + pi * pi / 3;
  EXPECT_NEAR(fact(shown, "mean of 3 X plus mean of X squared"), mean, 1e-6);
  const double apart = 9 * pi * pi / 12 + 4 * std::pow(pi, 4) / 45, together = apart + std::pow(pi, 3) / 2;
  EXPECT_NEAR(fact(shown, "variance of 3 X plus variance of X squared"), apart, 1e-5);
  EXPECT_NEAR(fact(shown, "variance of their sum"), together, 1e-5);
  EXPECT_NEAR(fact(shown, "mean of their sum, 65536 samples"), mean, 4 * std::sqrt(together) / 256);
}

}  // namespace
}  // namespace lambert::lab
