#include "lambert/sampling/distribution.h"

#include "lambert/base/error.h"
#include "lambert/sampling/sampling_test_tools.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

namespace lambert {
namespace {

std::vector<float> random_weights(std::size_t n, std::uint64_t seed) {
  TestNumbers random(seed);
  std::vector<float> weights(n);
  for (float& w : weights) w = std::max(0.0f, 5 * random() - 1);  // a fifth of them are 0
  return weights;
}

const std::vector<std::vector<float>> tables = {{1},
                                                {0, 0, 3},
                                                {1, 0, 0, 0},
                                                {0, 2, 0, 0, 1, 0},
                                                {1e-30f, 3e-30f},
                                                {3e38f, 3e38f, 1e38f},
                                                random_weights(7, 1),
                                                random_weights(100, 2),
                                                random_weights(1000, 3)};

template <class Table>
class BothTables : public testing::Test {};
using Tables = testing::Types<DiscreteDistribution, AliasTable>;
TYPED_TEST_SUITE(BothTables, Tables);

// rows: PT-13
TYPED_TEST(BothTables, ProbabilitiesAreSharesOfTheSum) {
  for (const auto& weights : tables) {
    const TypeParam table(weights);
    ASSERT_EQ(table.size(), weights.size());
    double sum = 0;
    for (const float w : weights) sum += static_cast<double>(w);
    for (std::size_t i = 0; i < weights.size(); ++i)
      EXPECT_NEAR(static_cast<double>(table.probability(i)), static_cast<double>(weights[i]) / sum, 1.2e-7);
  }
}

// rows: PT-13
TYPED_TEST(BothTables, BinsComeAsOftenAsTheyShould) {
  for (const auto& weights : tables) {
    const TypeParam table(weights);
    TestNumbers random(4);
    constexpr int n = 50000;
    std::vector<double> observed(weights.size()), expected(weights.size());
    for (int i = 0; i < n; ++i) {
      const Bin bin = table.sample(random());
      ++observed[bin.index];
      ASSERT_EQ(bin.probability, table.probability(bin.index));
    }
    for (std::size_t i = 0; i < weights.size(); ++i) expected[i] = n * static_cast<double>(table.probability(i));
    const auto result = statistics::chi_square(observed, expected, 2 * static_cast<int>(tables.size()));
    EXPECT_TRUE(result) << weights.size() << " weights: " << result.message;
  }
}

TYPED_TEST(BothTables, BinsWithoutWeightAreNeverDrawn) {
  for (const auto& weights : tables) {
    const TypeParam table(weights);
    TestNumbers random(5);
    for (int i = 0; i < 20000; ++i) ASSERT_GT(weights[table.sample(random()).index], 0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const float edge = static_cast<float>(i) / static_cast<float>(weights.size());
      ASSERT_GT(weights[table.sample(edge).index], 0);
    }
    EXPECT_GT(weights[table.sample(one_minus_epsilon).index], 0);
  }
}

TYPED_TEST(BothTables, WeightsThatAreAllZeroCountAsEqual) {
  const TypeParam table(std::array<float, 4>{});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(table.probability(i), 0.25f);
    EXPECT_EQ(table.sample(0.25f * static_cast<float>(i) + 0.1f).index, i);
  }
}

TYPED_TEST(BothTables, BadWeightsAreNamed) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {-1.0f, -1e-30f, inf, nan}) {
    try {
      TypeParam(std::array{1.0f, 2.0f, bad});
      ADD_FAILURE() << bad << " was accepted";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("weight 2"), std::string::npos) << e.what();
    }
  }
  EXPECT_THROW(TypeParam(std::span<const float>()), Error);
}

// rows: PT-13
TEST(DiscreteDistribution, BinsOwnTheirLowerEnd) {
  const DiscreteDistribution d(std::array{2.0f, 3.0f, 4.0f, 1.0f});
  const std::array<float, 5> edges = {0, 0.2f, 0.5f, 0.9f, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(d.cumulative()[i], edges[i]);
    EXPECT_EQ(d.sample(edges[i]).index, i);
    EXPECT_EQ(d.sample(std::nextafter(edges[i + 1], 0.0f)).index, i);
  }
  EXPECT_EQ(d.cumulative()[4], 1);
}

// rows: PT-13
TEST(DiscreteDistribution, WhatIsLeftOfANumberIsANumber) {
  for (const auto& weights : tables) {
    const DiscreteDistribution d(weights);
    std::array<double, 16> observed{}, expected{};
    expected.fill(50000 / 16.0);
    TestNumbers random(6);
    for (int i = 0; i < 50000; ++i) {
      const float u = random();
      float within = -1;
      const Bin bin = d.sample(u, within);
      ASSERT_TRUE(within >= 0 && within < 1) << within;
      EXPECT_NEAR(d.cumulative()[bin.index] + within * bin.probability, u, 1.2e-7f);
      ++observed[static_cast<std::size_t>(within * 16)];
    }
    const auto result = statistics::chi_square(observed, expected, static_cast<int>(tables.size()));
    EXPECT_TRUE(result) << weights.size() << " weights: " << result.message;
  }
}

TEST(DiscreteDistribution, ManyBinsAddUp) {
  const DiscreteDistribution d(random_weights(300000, 7));
  double sum = 0;
  for (std::size_t i = 0; i < d.size(); ++i) sum += static_cast<double>(d.probability(i));
  EXPECT_DOUBLE_EQ(sum, 1);
  EXPECT_TRUE(std::is_sorted(d.cumulative().begin(), d.cumulative().end()));
  EXPECT_GT(d.sample(one_minus_epsilon).probability, 0);
}

// Each bin's share of the unit interval, measured on a grid finer than any threshold.
TEST(AliasTable, DealsOutTheUnitIntervalByWeight) {
  const std::array<float, 5> weights = {1, 0, 6, 2, 0.5f};
  const AliasTable table(weights);
  constexpr int n = 1 << 16;
  std::array<double, 5> share{};
  for (int i = 0; i < n; ++i) share[table.sample((static_cast<float>(i) + 0.5f) / n).index] += 1.0 / n;
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(share[i], static_cast<double>(weights[i]) / 9.5, 1e-4) << "bin " << i;
}

}  // namespace
}  // namespace lambert
