#include "lambert/material/spectrum.h"

#include "lambert/base/vec.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TEST(Wavelength, WeightsHaveMeanOneAndAreNeverNegative) {
  constexpr int n = 200000;
  double r = 0, g = 0, b = 0;
  for (int i = 0; i < n; ++i) {
    const float nm = sample_wavelength((static_cast<float>(i) + 0.5f) / n);
    ASSERT_GE(nm, 380);
    ASSERT_LE(nm, 720);
    const Rgb w = wavelength_rgb(nm);
    ASSERT_GE(min_component(w), 0);
    ASSERT_NEAR(average(w), 1, 1e-5f) << "bounded weights";
    r += static_cast<double>(w.r), g += static_cast<double>(w.g), b += static_cast<double>(w.b);
  }
  EXPECT_NEAR(r / n, 1, 1e-3);
  EXPECT_NEAR(g / n, 1, 1e-3);
  EXPECT_NEAR(b / n, 1, 1e-3);
}

TEST(Wavelength, StaysInRangeAtTheEndsOfTheUnitInterval) {
  EXPECT_GE(sample_wavelength(0), 380);
  EXPECT_LE(sample_wavelength(one_minus_epsilon), 720);
}

TEST(Wavelength, HuesRunFromRedToViolet) {
  const auto largest = [](Rgb c) { return c.r >= c.g && c.r >= c.b ? 'r' : c.g >= c.b ? 'g' : 'b'; };
  EXPECT_EQ(largest(wavelength_rgb(650)), 'r');
  EXPECT_EQ(largest(wavelength_rgb(530)), 'g');
  EXPECT_EQ(largest(wavelength_rgb(460)), 'b');
  const Rgb violet = wavelength_rgb(420);
  EXPECT_EQ(largest(violet), 'b');
  EXPECT_GT(violet.r, violet.g) << "violet has some red again";
  EXPECT_GT(wavelength_rgb(580).g, 0.2f) << "yellow lies between";
}

TEST(Cauchy, PassesThroughTheLinesOfTheAbbeNumber) {
  EXPECT_FLOAT_EQ(cauchy_eta(1.5168f, 64.17f, 587.6f), 1.5168f);
  const float f = cauchy_eta(1.5168f, 64.17f, 486.1f), c = cauchy_eta(1.5168f, 64.17f, 656.3f);
  EXPECT_NEAR((1.5168f - 1) / (f - c), 64.17f, 0.05f);
  EXPECT_GT(f, c) << "blue is refracted more";
}

// Schott's N-BK7 data sheet: n_F = 1.52238, n_C = 1.51432. The two-term formula is that good.
TEST(Cauchy, MatchesBk7) {
  EXPECT_NEAR(cauchy_eta(1.5168f, 64.17f, 486.1f), 1.52238f, 3e-4f);
  EXPECT_NEAR(cauchy_eta(1.5168f, 64.17f, 656.3f), 1.51432f, 3e-4f);
}

TEST(Cauchy, WithoutAnAbbeNumberThereIsNoDispersion) { EXPECT_FLOAT_EQ(cauchy_eta(1.7f, 0, 400), 1.7f); }

}  // namespace
}  // namespace lambert
