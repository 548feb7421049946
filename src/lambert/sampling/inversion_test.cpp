#include "lambert/sampling/inversion.h"

#include "lambert/sampling/sampling_test_tools.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lambert {
namespace {

// rows: PT-14 PT-15
TEST(Inversion, AgreesWithTheClosedForm) {
  for (const double n : {0.0, 1.0, 3.0, 40.0})
    for (const double u : {1e-9, 0.0625, 0.5, 0.81, 0.999999}) {
      const double x = invert_cdf([n](double t) { return std::pow(t, n + 1); }, u, 0, 1);
      EXPECT_NEAR(x, std::pow(u, 1 / (n + 1)), 1e-12) << n << " " << u;
    }
}

// rows: PT-07 PT-14
// Density x e^-x has the cumulative density 1 - (1 + x) e^-x, which has no inverse in elementary functions.
TEST(Inversion, FollowsADensityWithoutClosedInverse) {
  const auto cdf = [](double x) { return 1 - (1 + x) * std::exp(-x); };
  constexpr int cells = 20, n = 20000;
  std::array<double, cells> observed{}, expected{};
  TestNumbers random(1);
  int evaluations = 0;
  for (int i = 0; i < n; ++i) {
    const auto counted = [&](double x) { return ++evaluations, cdf(x); };
    const double x = invert_cdf(counted, static_cast<double>(random()), 0, 60);
    ++observed[static_cast<std::size_t>(std::min(cells - 1.0, 2 * x))];
  }
  for (int i = 0; i < cells; ++i)
    expected[static_cast<std::size_t>(i)] = n * ((i + 1 < cells ? cdf(0.5 * (i + 1)) : 1) - cdf(0.5 * i));
  const auto result = statistics::chi_square(observed, expected);
  EXPECT_TRUE(result) << result.message;
  EXPECT_LE(evaluations, 53 * n);
}

TEST(Inversion, StepsAreFoundAndFlatPartsSkipped) {
  const auto two_boxes = [](double x) { return x < 1 ? 0.5 * x : x < 2 ? 0.5 : 0.5 * (x - 1); };
  EXPECT_NEAR(invert_cdf(two_boxes, 0.25, 0, 3), 0.5, 1e-12);
  EXPECT_NEAR(invert_cdf(two_boxes, 0.5, 0, 3), 2, 1e-12) << "nothing lies between 1 and 2";
  EXPECT_NEAR(invert_cdf([](double x) { return x < 1.25 ? 0.0 : 1.0; }, 0.7, 0, 3), 1.25, 1e-12);
}

}  // namespace
}  // namespace lambert
