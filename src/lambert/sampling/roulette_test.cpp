#include "lambert/sampling/roulette.h"

#include "lambert/sampling/sampling_test_tools.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

// rows: PT-26
TEST(Roulette, SurvivorsStandForTheAbsorbed) {
  for (const float survival : {0.1f, 0.5f, 0.95f}) {
    TestNumbers random(1);
    Mean factor;
    for (int i = 0; i < 20000; ++i) factor.add(static_cast<double>(russian_roulette(survival, random())));
    const auto result = statistics::z_test(factor.value(), factor.standard_error(), 1, 3);
    EXPECT_TRUE(result) << survival << ": " << result.message;
  }
  EXPECT_EQ(russian_roulette(1, one_minus_epsilon), 1);
  EXPECT_EQ(russian_roulette(0, 0), 0);
}

// rows: PT-26
// E-PT-09: the series 1 + 1/2 + 1/4 + … = 2, ended by roulette.
TEST(Roulette, EndsASeriesWithoutBias) {
  TestNumbers random(2);
  Mean sum, without_division;
  for (int i = 0; i < 20000; ++i) {
    double total = 0, plain = 0, throughput = 1, term = 1;
    for (;;) {
      total += throughput, plain += term;
      const float factor = russian_roulette(0.5f, random());
      if (factor == 0) break;
      throughput *= 0.5 * static_cast<double>(factor), term *= 0.5;
    }
    sum.add(total), without_division.add(plain);
  }
  const auto result = statistics::z_test(sum.value(), sum.standard_error(), 2);
  EXPECT_TRUE(result) << result.message;
  EXPECT_NEAR(without_division.value(), 4.0 / 3, 0.02);
}

}  // namespace
}  // namespace lambert
