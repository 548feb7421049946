#include "lambert/lab/demo.h"
#include "lambert/lab/demo_test_tools.h"
#include "lambert/lab/periodogram.h"
#include "lambert/lab/scenes.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambert::lab {
namespace {

TEST(Demos, SayWhatTheirPictureIs) {
  for (const Demo& d : demos())
    EXPECT_EQ(std::holds_alternative<draw::Drawing>(d.show({}).picture), d.has_drawing) << d.name;
}

TEST(Periodogram, OfOnePointIsFlatAndOfAGridIsPeaks) {
  for (const double p : periodogram(std::vector<Vec2>{{0.3f, 0.7f}}, 5)) EXPECT_NEAR(p, 1, 1e-12);
  const auto grid = periodogram(regular_points(4), 8);
  for (int y = -8; y <= 8; ++y)
    for (int x = -8; x <= 8; ++x)
      EXPECT_NEAR(grid[static_cast<std::size_t>((y + 8) * 17 + x + 8)], x % 4 == 0 && y % 4 == 0 ? 16 : 0, 1e-9);
}

// rows: AA-15
TEST(Periodogram, RandomPointsHavePowerOneAndStratifiedOnesLessAtLowFrequencies) {
  const auto low_power = [](PatternKind kind) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const auto mean = radial_mean(periodogram(pattern_points(kind, 256, seed), 8), 8);
      for (std::size_t r = 1; r <= 4; ++r) sum += mean[r] / 160;
    }
    return sum;
  };
  // About 50 independent frequencies with |k| <= 4 (half of 69), 40 sets, exponential powers: deviation 0.03.
  EXPECT_NEAR(low_power(PatternKind::random), 1, 0.1);
  EXPECT_LT(low_power(PatternKind::jittered), 0.2);
  EXPECT_LT(low_power(PatternKind::poisson_disk), 0.2);
  EXPECT_LT(low_power(PatternKind::best_candidate), 0.2);
}

// rows: AA-16
TEST(Comb, RegularSamplesShowOneFalseToothOf101Pixels) {
  const Image regular = sampled(comb({.teeth = 300, .top = 0}), 303, 50, {PatternKind::regular, 1, 1});
  // Row 25: half of each tooth is lit; what is seen is lit and dark in runs of half the false period.
  std::vector<int> starts;
  for (int x = 1; x < 303; ++x)
    if (regular.rgb(x, 25).r > 0 && regular.rgb(x - 1, 25).r == 0) starts.push_back(x);
  ASSERT_EQ(starts.size(), 3u);
  EXPECT_EQ(starts[1] - starts[0], 101);
  EXPECT_EQ(starts[2] - starts[1], 101);
  EXPECT_NEAR(alias_period(1.01), 101, 1e-9);
  // The mean of a row is the share lit, y / height, up to the noise of 303 yes-or-no samples.
  const Image jittered = sampled(comb({.teeth = 300, .top = 0}), 303, 50, {PatternKind::jittered, 16, 1});
  double mean = 0;
  for (int x = 0; x < 303; ++x) mean += static_cast<double>(jittered.rgb(x, 25).r) / 303;
  EXPECT_NEAR(mean, 0.51, 0.03);
}

// rows: AA-05
TEST(Nyquist, FrequenciesFoldBelowHalfTheRate) {
  for (const double f : {3.0, 4.9, 7.0, 9.0, 12.0, 21.0}) {
    const double folded = alias_frequency(f, 10);
    EXPECT_LE(folded, 5);
    // The samples of both are the same, up to sign.
    const double direction =
        std::sin(2 * std::numbers::pi * f / 10) * std::sin(2 * std::numbers::pi * folded / 10) < 0 ? -1 : 1;
    for (int n = 0; n < 20; ++n)
      EXPECT_NEAR(std::sin(2 * std::numbers::pi * f * n / 10),
                  direction * std::sin(2 * std::numbers::pi * folded * n / 10), 1e-12);
  }
}

// rows: AA-03
TEST(Moire, BandsComeWhereTheLayersFallInStep) {
  // Lines of 6 and 5.7 pixels fall in step every 114: twenty of the ones are nineteen of the others.
  const Scene scene = moire({.period = 6}, {.period = 5.7});
  const auto lit_near = [&](double x) {
    int lit = 0;
    for (int i = 0; i < 600; ++i) lit += scene({x + i * 0.01, 0.5}).r > 0.5f;
    return lit;
  };
  EXPECT_GT(lit_near(112), 250);  // in step: half is lit
  EXPECT_LT(lit_near(54), 60);    // out of step: next to nothing
  EXPECT_NEAR(fact(show_moire({}), "bands of the slid layers, pixels"), 114, 1e-9);
}

// rows: AA-04 AA-06 AA-14 AA-17 AA-19
TEST(Demos, SayWhatTheirPicturesShow) {
  const Shown detail = show_detail({});
  EXPECT_GT(fact(detail, "rms error, blurred"), 2 * fact(detail, "rms error, 9 samples"));
  const Shown pixel = show_pixel({});
  EXPECT_DOUBLE_EQ(fact(pixel, "red by regular samples"), 2.0 / 9);
  EXPECT_DOUBLE_EQ(fact(pixel, "red by jittered samples"), 1.0 / 9);
  const Shown jitter = show_jitter({});
  EXPECT_LT(fact(jitter, "rms error, 4 jittered"), 0.75 * fact(jitter, "rms error, 1 jittered"));
  EXPECT_LT(fact(jitter, "rms error, 4 jittered"), fact(jitter, "rms error, 4 random"));
  const Shown best = show_best_candidate({});
  EXPECT_LT(fact(best, "rms error, 1 sample a pixel, best-candidate"),
            1.02 * fact(best, "rms error, 1 sample a pixel, jittered"));
}

// rows: PT-22
TEST(Demos, ErrorsFallAsTheyShould) {
  const Shown error = show_error({});
  EXPECT_NEAR(fact(error, "slope, random"), -0.5, 0.06);
  // An edge crosses √n of n strata: -3/4.
  EXPECT_NEAR(fact(error, "slope, jittered"), -0.75, 0.08);
  EXPECT_LT(fact(error, "slope, sobol"), -0.65);
  const Shown noise = show_noise({});
  for (const int n : {1, 4, 16, 64})
    EXPECT_NEAR(fact(noise, "rms error, " + std::to_string(n) + " samples") /
                    fact(noise, "rms error, " + std::to_string(4 * n) + " samples"),
                2, 0.08);
}

// rows: PT-06 PT-10 PT-11
TEST(Demos, EstimatorsHaveTheVarianceOfTheirDensity) {
  const Shown shown = show_quadrature({});
  for (const char* density : {"uniform density", "density 2x/15"})
    EXPECT_NEAR(fact(shown, std::string("rms error times root of n, ") + density) /
                    fact(shown, std::string("deviation of a term, ") + density),
                1, 0.12);
  const Shown dimensions = show_dimensions({});
  for (const int d : {1, 2, 4, 8})
    EXPECT_NEAR(fact(dimensions, "slope of random points, " + std::to_string(d) + " variables"), -0.5, 0.05) << d;
}

// rows: PT-13 PT-15 PT-16 PT-17 PT-19 PT-20 PT-21
TEST(Demos, WarpsHaveTheirMoments) {
  const Shown inversion = show_inversion({});
  EXPECT_NEAR(fact(inversion, "mean of the power distribution (0.8)"), 0.8, 0.01);
  EXPECT_NEAR(fact(inversion, "share of the third bin (0.4)"), 0.4, 0.03);
  const Shown rejection = show_rejection({});
  EXPECT_NEAR(fact(rejection, "share accepted"), fact(rejection, "pi / 4"), 0.05);
  const Shown disk = show_disk({});
  EXPECT_NEAR(fact(disk, "share within half the radius, r = xi"), 0.5, 0.02);
  EXPECT_NEAR(fact(disk, "share within half the radius, r = root of xi"), 0.25, 0.02);
  EXPECT_NEAR(fact(disk, "share within half the radius, concentric"), 0.25, 0.02);
  const Shown sphere = show_sphere({});
  EXPECT_NEAR(fact(sphere, "mean of z squared on the sphere (1/3)"), 1.0 / 3, 0.01);
  EXPECT_NEAR(fact(sphere, "mean of z, uniform hemisphere (1/2)"), 0.5, 0.01);
  EXPECT_NEAR(fact(sphere, "mean of z, cosine hemisphere (2/3)"), 2.0 / 3, 0.01);
  const Shown environment = show_environment({});
  EXPECT_NEAR(fact(environment, "probability of the top row of a constant sky, brightness alone"), 0.01562, 1e-4);
  EXPECT_NEAR(fact(environment, "probability of the top row of a constant sky, with sin theta"), 0.00060, 1e-5);
}

TEST(Demos, DoNotDependOnThreads) {
  const auto image = [] { return std::get<Image>(show_jitter({.seed = 5}).picture); };
  set_thread_count(1);
  const Image one = image();
  set_thread_count(2);
  const Image two = image();
  set_thread_count(0);
  EXPECT_TRUE(std::equal(one.pixels().begin(), one.pixels().end(), two.pixels().begin()));
}

TEST(Demos, AreFoundByName) {
  EXPECT_STREQ(demo("comb").name, "comb");
  EXPECT_THROW(demo("kamm"), Error);
}

}  // namespace
}  // namespace lambert::lab
