/// Monte Carlo estimators in their textbook forms, fed by the library's warps, tables and samplers.

#include "lambert/sampling/quadrature.h"
#include "lambert/sampling/sampler.h"
#include "lambert/sampling/sampling_test_tools.h"
#include "lambert/sampling/warp.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace lambert {
namespace {

Mean estimate(int n, std::uint64_t seed, const std::function<double(TestNumbers&)>& term) {
  TestNumbers random(seed);
  Mean mean;
  for (int i = 0; i < n; ++i) mean.add(term(random));
  return mean;
}

void expect_mean(const Mean& m, double expected, int tests = 1) {
  const auto result = statistics::z_test(m.value(), m.standard_error(), expected, tests);
  EXPECT_TRUE(result) << m.value() << " for " << expected << ": " << result.message;
}

// rows: PT-06
TEST(Quadrature, GridSums) {
  EXPECT_NEAR(midpoint_integral([](double x) { return x; }, 0, 2, 1000), 2, 1e-12);
  const auto error = [](int n) { return midpoint_integral([](double x) { return x * x; }, 1, 4, n) - 21; };
  EXPECT_NEAR(error(100) / error(200), 4, 1e-3) << "the error falls as 1/n²";
}

// rows: PT-09 PT-10
// E-PT-04: x² over 1..4 is 21, uniformly (b - a) / n Σ f and with density 2x / 15.
TEST(Estimator, OfASquareUniformlyAndByDensity) {
  const Mean uniform = estimate(20000, 1, [](TestNumbers& random) {
    const double x = 1 + 3 * static_cast<double>(random());
    return 3 * x * x;
  });
  const Mean by_density = estimate(20000, 2, [](TestNumbers& random) {
    const double x = std::sqrt(1 + 15 * static_cast<double>(random()));
    return x * x / (2 * x / 15);
  });
  expect_mean(uniform, 21, 2);
  expect_mean(by_density, 21, 2);
  EXPECT_LT(by_density.variance(), 0.3 * uniform.variance()) << "the density resembles the integrand";
}

// rows: PT-11
// ∫ over the box 0..1 x 0..2 x 0..3 of x y z = 1/2 · 2 · 9/2.
TEST(Estimator, OfABoxInThreeDimensions) {
  expect_mean(estimate(20000, 3,
                       [](TestNumbers& random) {
                         const double x = static_cast<double>(random()), y = 2 * static_cast<double>(random());
                         return 6 * x * y * 3 * static_cast<double>(random());
                       }),
              4.5);
}

/// The root mean square error of many estimates of n samples of a d-dimensional mean.
double rms_error(int n, int d) {
  double sum = 0;
  constexpr int runs = 2000;
  for (int run = 0; run < runs; ++run) {
    const Mean m = estimate(n, static_cast<std::uint64_t>(1000 + run), [d](TestNumbers& random) {
      double product = 1;
      for (int i = 0; i < d; ++i) product *= 0.5 + static_cast<double>(random());
      return product;
    });
    sum += (m.value() - 1) * (m.value() - 1);
  }
  return std::sqrt(sum / runs);
}

// rows: PT-11 PT-22
TEST(Estimator, ErrorFallsWithTheRootOfTheSamplesInAnyDimension) {
  for (const int d : {1, 2, 8}) EXPECT_NEAR(rms_error(16, d) / rms_error(64, d), 2, 0.2) << d << " dimensions";
}

// rows: PT-08
TEST(Estimator, MeanOfTheCosine) {
  const auto mean_cosine = [](double end) {
    return [end](TestNumbers& random) { return std::cos(end * static_cast<double>(random())); };
  };
  expect_mean(estimate(20000, 4, mean_cosine(std::numbers::pi)), 0, 2);
  expect_mean(estimate(20000, 5, mean_cosine(std::numbers::pi / 2)), 2 / std::numbers::pi, 2);
}

// rows: PT-18
// E-PT-06: irradiance under L = 1 is π, with p per solid angle and with p per (θ, φ), where sin θ enters.
TEST(Estimator, HemisphereIntegralOfTheCosine) {
  const double half_pi = std::numbers::pi / 2, two_pi = 2 * std::numbers::pi;
  expect_mean(estimate(20000, 6,
                       [](TestNumbers& random) {
                         const Vec3 w = square_to_uniform_hemisphere(random.pair());
                         return static_cast<double>(w.z / uniform_hemisphere_pdf(w));
                       }),
              std::numbers::pi, 2);
  expect_mean(estimate(20000, 7,
                       [=](TestNumbers& random) {
                         const double theta = half_pi * static_cast<double>(random());
                         return std::cos(theta) * std::sin(theta) * (half_pi * two_pi);
                       }),
              std::numbers::pi, 2);
  const Mean cosine = estimate(1000, 8, [](TestNumbers& random) {
    const Vec3 w = square_to_cosine_hemisphere(random.pair());
    return static_cast<double>(w.z / cosine_hemisphere_pdf(w));
  });
  EXPECT_NEAR(cosine.value(), std::numbers::pi, 1e-5);
  EXPECT_LT(cosine.variance(), 1e-9) << "a density in proportion has no variance";
}

}  // namespace
}  // namespace lambert
