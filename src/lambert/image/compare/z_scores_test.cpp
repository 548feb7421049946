#include "lambert/image/compare/z_scores.h"

#include "damage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lambert::compare {
namespace {

/// Normal pixels of the given mean and deviation, with the variance that they have.
Image estimate(unsigned seed, double mean, double deviation, int size = 64) {
  Image image(size, size, {"R", "G", "B", "variance.Y"});
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(mean, deviation);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      image.set_rgb(x, y, Rgb(static_cast<float>(normal(generator))));
      image.at(x, y, 3) = static_cast<float>(deviation * deviation);
    }
  return image;
}

TEST(ZTest, AcceptsTwoEstimatesOfOneImageAsOftenAsItSays) {
  int rejected = 0;
  for (unsigned seed = 0; seed < 200; ++seed)
    if (!z_test(estimate(2 * seed, 1, 0.1), estimate(2 * seed + 1, 1, 0.2)).same(0.05)) ++rejected;
  // Binomial(200, 0.05): 10 expected, deviation 3.1.
  EXPECT_GE(rejected, 1);
  EXPECT_LE(rejected, 22);
}

TEST(ZTest, RejectsASmallBias) {
  const ZTest test = z_test(estimate(1, 1, 0.1), estimate(2, 1.02, 0.1));
  EXPECT_LT(test.p_mean, 1e-4);
  EXPECT_FALSE(test.same(0.01));
}

TEST(ZTest, RejectsOneWrongPixelAndNamesIt) {
  Image a = estimate(1, 1, 0.1);
  a.set_rgb(5, 9, Rgb(3));
  const ZTest test = z_test(a, estimate(2, 1, 0.1));
  EXPECT_EQ(test.x, 5);
  EXPECT_EQ(test.y, 9);
  EXPECT_LT(test.p_largest, 1e-9);
  EXPECT_GT(test.p_mean, 1e-3);
}

TEST(ZTest, RejectsVariancesThatAreTooSmall) {
  Image a = estimate(1, 1, 0.1);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) a.at(x, y, 3) *= 0.5f;
  EXPECT_LT(z_test(a, Image(estimate(2, 1, 0))).p_spread, 1e-9);
}

TEST(ZTest, CountsDifferencesThatNothingExplains) {
  const Image a = estimate(1, 1, 0), b = estimate(1, 2, 0);
  EXPECT_EQ(z_test(a, b).certain, 64u * 64);
  EXPECT_FALSE(z_test(a, b).same(0.01));
  EXPECT_TRUE(z_test(a, a).same(0.01));
}

TEST(ZTest, NeedsVariances) {
  EXPECT_NE(error_of([] { z_test(Image(1, 1, {"Y"}), Image(1, 1, {"Y"})); }).find("variance.Y"), std::string::npos);
}

}  // namespace
}  // namespace lambert::compare
