#include "lambert/base/error.h"
#include "lambert/sampling/distribution.h"
#include "lambert/sampling/sampling_test_tools.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace lambert {
namespace {

const std::vector<std::vector<float>> steps = {{2}, {0, 1, 0}, {1, 3, 0, 2, 5}, {0, 0, 1e-3f, 1e3f}};

// rows: PT-07 PT-14
TEST(PiecewiseConstant1D, IsSampledByInversion) {
  for (const auto& weights : steps) {
    const PiecewiseConstant1D d(weights);
    TestNumbers random(1);
    float last = -1;
    for (int i = 0; i < 1000; ++i) {
      const float u = (static_cast<float>(i) + random()) / 1000;
      const auto s = d.sample(u);
      EXPECT_GE(s.x, last) << "an inverse of a cumulative density does not fall";
      EXPECT_NEAR(d.to_uniform(s.x), u, 1e-5f);
      EXPECT_GT(s.pdf, 0);
      last = s.x;
    }
  }
}

// rows: PT-14
TEST(PiecewiseConstant1D, FollowsItsDensity) {
  for (const auto& weights : steps) {
    const PiecewiseConstant1D d(weights);
    TestNumbers random(2);
    const std::size_t cells = 3 * weights.size();
    std::vector<double> observed(cells), expected(cells);
    double integral = 0;
    for (std::size_t i = 0; i < cells; ++i) {
      const auto width = 1 / static_cast<double>(cells);
      const auto middle = static_cast<float>((static_cast<double>(i) + 0.5) * width);
      const double share = static_cast<double>(d.pdf(middle)) * width;
      expected[i] = 30000 * share, integral += share;
    }
    EXPECT_NEAR(integral, 1, 1e-6);
    for (int i = 0; i < 30000; ++i)
      ++observed[static_cast<std::size_t>(d.sample(random()).x * static_cast<float>(cells))];
    const auto result = statistics::chi_square(observed, expected, static_cast<int>(steps.size()));
    EXPECT_TRUE(result) << result.message;
  }
}

// A place that rounding moved into the next bin would be looked up there, where the density may be 0.
TEST(PiecewiseConstant1D, APlaceLiesInTheBinThatWasDrawn) {
  for (const std::size_t n : {3u, 5u, 7u, 100u, 1000u, 4095u}) {
    std::vector<float> weights(n, 1);
    for (std::size_t i = 1; i < n; i += 2) weights[i] = 0;
    const PiecewiseConstant1D d(weights);
    const DiscreteDistribution bins(weights);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      float u = bins.cumulative()[i + 1];
      for (int ulp = 0; ulp < 4; ++ulp) {
        const auto s = d.sample(std::min(u, one_minus_epsilon));
        ASSERT_EQ(d.pdf(s.x), s.pdf) << "bin " << s.bin << " of " << n << ", x = " << s.x;
        u = std::nextafter(u, 0.0f);
      }
    }
  }
}

TEST(PiecewiseConstant1D, EndsBelongToTheFirstAndTheLastBin) {
  const PiecewiseConstant1D d(std::array{1.0f, 2.0f, 5.0f});
  EXPECT_FLOAT_EQ(d.pdf(0), 3.0f / 8);
  EXPECT_FLOAT_EQ(d.pdf(1), 15.0f / 8);
  EXPECT_EQ(d.to_uniform(0), 0);
  EXPECT_EQ(d.to_uniform(1), 1);
  EXPECT_LT(d.sample(one_minus_epsilon).x, 1);
}

const std::array<float, 12> image = {1, 3, 0, 2,  //
                                     0, 0, 0, 0,  //
                                     4, 0, 8, 1};

// rows: PT-21
TEST(PiecewiseConstant2D, DensityIsWeightOverMean) {
  const PiecewiseConstant2D d(image, 4, 3);
  for (std::size_t y = 0; y < 3; ++y)
    for (std::size_t x = 0; x < 4; ++x) {
      const Vec2 middle((static_cast<float>(x) + 0.5f) / 4, (static_cast<float>(y) + 0.5f) / 3);
      EXPECT_NEAR(d.pdf(middle), image[y * 4 + x] * 12 / 19, 1e-6f);
    }
}

// rows: PT-21
TEST(PiecewiseConstant2D, FollowsItsDensity) {
  const PiecewiseConstant2D d(image, 4, 3);
  const auto result = statistics::chi_square_square([&](Vec2 u) { return d.sample(u).uv; },
                                                    [&](Vec2 uv) { return static_cast<double>(d.pdf(uv)); },
                                                    {.polar_bins = 6, .azimuth_bins = 8, .subdivisions = 2});
  EXPECT_TRUE(result) << result.message;
}

// rows: PT-21
TEST(PiecewiseConstant2D, ForwardAndInverseUndoEachOther) {
  const PiecewiseConstant2D d(image, 4, 3);
  TestNumbers random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 u = random.pair();
    const auto s = d.sample(u);
    EXPECT_EQ(d.pdf(s.uv), s.pdf);
    EXPECT_LT(length(d.to_square(s.uv) - u), 1e-5f);
  }
}

TEST(PiecewiseConstant2D, AllZeroIsUniformAndBadWeightsAreErrors) {
  const PiecewiseConstant2D d(std::array<float, 6>{}, 3, 2);
  EXPECT_FLOAT_EQ(d.pdf({0.9f, 0.1f}), 1);
  EXPECT_LT(length(d.sample({0.3f, 0.7f}).uv - Vec2(0.3f, 0.7f)), 1e-6f);
  EXPECT_THROW(PiecewiseConstant2D(std::array{1.0f, NAN, 1.0f, 1.0f}, 2, 2), Error);
  EXPECT_THROW(PiecewiseConstant2D(std::array{1.0f, 1.0f, -1.0f, 1.0f}, 2, 2), Error);
}

}  // namespace
}  // namespace lambert
