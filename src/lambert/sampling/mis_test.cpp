#include "lambert/sampling/mis.h"

#include "lambert/sampling/sampling_test_tools.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <limits>

namespace lambert {
namespace {

using Heuristic = float (*)(float, float);
constexpr Heuristic heuristics[] = {balance_heuristic, power_heuristic};

// rows: PT-29
TEST(Mis, WeightsAddUpToOne) {
  for (const Heuristic weight : heuristics)
    for (const float p : {1e-30f, 1e-6f, 0.3f, 1.0f, 70.0f, 1e20f})
      for (const float q : {0.0f, 1e-30f, 1e-3f, 0.3f, 5.0f, 1e20f}) EXPECT_NEAR(weight(p, q) + weight(q, p), 1, 1e-6f);
}

TEST(Mis, AStrategyThatCannotHasNoWeight) {
  for (const Heuristic weight : heuristics) {
    EXPECT_EQ(weight(0, 2), 0);
    EXPECT_EQ(weight(0, 0), 0);
    EXPECT_EQ(weight(2, 0), 1);
  }
  EXPECT_EQ(power_heuristic(std::numeric_limits<float>::infinity(), 3), 1);
}

TEST(Mis, KnownValues) {
  EXPECT_FLOAT_EQ(balance_heuristic(3, 1), 0.75f);
  EXPECT_FLOAT_EQ(power_heuristic(3, 1), 0.9f);
}

// rows: PT-29
// ∫ 3x² = 1 by one uniform sample and one of density 2x: unbiased, and better than either strategy alone.
TEST(Mis, CombinesTwoStrategiesWithoutBias) {
  const auto f = [](float x) { return 3 * x * x; };
  for (const Heuristic weight : heuristics) {
    TestNumbers random(1);
    Mean combined, uniform, linear;
    for (int i = 0; i < 20000; ++i) {
      const float x = random(), y = std::sqrt(random());
      const float of_x = f(x), of_y = y > 0 ? f(y) / (2 * y) : 0;
      combined.add(static_cast<double>(weight(1, 2 * x) * of_x + weight(2 * y, 1) * of_y));
      uniform.add(static_cast<double>(of_x)), linear.add(static_cast<double>(of_y));
    }
    const auto result = statistics::z_test(combined.value(), combined.standard_error(), 1, 2);
    EXPECT_TRUE(result) << result.message;
    EXPECT_LT(combined.variance(), 0.5 * uniform.variance());
  }
}

}  // namespace
}  // namespace lambert
