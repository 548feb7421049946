#include "lambert/sampling/rejection.h"

#include "lambert/sampling/sampling_test_tools.h"
#include "lambert/sampling/warp.h"
#include "statistics/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace lambert {
namespace {

// rows: PT-16
TEST(Rejection, TheDiskIsUniform) {
  TestNumbers random(1);
  constexpr int radii = 8, turns = 8, n = 30000;
  std::array<double, radii * turns> observed{}, expected{};
  expected.fill(static_cast<double>(n) / (radii * turns));
  for (int i = 0; i < n; ++i) {
    const auto p = disk_by_rejection(random);
    ASSERT_TRUE(p && dot(p->value, p->value) < 1);
    // Equal areas: r² and the angle are uniform.
    const Vec2 u = uniform_disk_polar_to_square(p->value);
    ++observed[static_cast<std::size_t>(u.x * radii) * turns + static_cast<std::size_t>(u.y * turns)];
  }
  const auto result = statistics::chi_square(observed, expected);
  EXPECT_TRUE(result) << result.message;
}

// rows: PT-16
// Tries are geometric: their mean is 1 / q, of standard deviation √(1 - q) / q.
TEST(Rejection, TheDiskAcceptsAShareOfAQuarterPi) {
  TestNumbers random(2);
  Mean tries;
  for (int i = 0; i < 30000; ++i) tries.add(disk_by_rejection(random)->tries);
  const auto result = statistics::z_test(tries.value(), tries.standard_error(), 4 / std::numbers::pi);
  EXPECT_TRUE(result) << result.message;
}

// rows: PT-16
// f = sin πx under c p = 1 and under c p = 1.5 x + 0.9 (which is above it): the same density, other tries.
TEST(Rejection, FollowsItsDensityWhateverIsProposed) {
  constexpr int cells = 20, n = 20000;
  const auto f = [](float x) { return std::sin(pi * x); };
  for (const bool linear : {false, true}) {
    TestNumbers random(3);
    std::array<double, cells> observed{}, expected{};
    Mean tries;
    // p = (1.5 x + 0.9) / 1.65 by inversion.
    const auto propose = [&] {
      const float u = random();
      return linear ? (std::sqrt(0.81f + 3 * 1.65f * u) - 0.9f) / 1.5f : u;
    };
    const auto acceptance = [&](float x) { return f(x) / (linear ? 1.5f * x + 0.9f : 1.0f); };
    for (int i = 0; i < n; ++i) {
      const auto x = sample_by_rejection(propose, acceptance, random);
      ASSERT_TRUE(x);
      tries.add(x->tries);
      ++observed[static_cast<std::size_t>(std::min(x->value * cells, cells - 1.0f))];
    }
    for (int i = 0; i < cells; ++i)
      expected[static_cast<std::size_t>(i)] =
          0.5 * n * (std::cos(std::numbers::pi * i / cells) - std::cos(std::numbers::pi * (i + 1) / cells));
    const auto result = statistics::chi_square(observed, expected, 4);
    EXPECT_TRUE(result) << result.message;
    const double per_sample = (linear ? 1.65 : 1) * std::numbers::pi / 2;  // c ∫p / ∫f
    EXPECT_TRUE(statistics::z_test(tries.value(), tries.standard_error(), per_sample, 4)) << tries.value();
  }
}

TEST(Rejection, GivesUpAfterItsTries) {
  int proposed = 0;
  const auto none = sample_by_rejection([&] { return ++proposed; }, [](int) { return 0.0f; }, [] { return 0.5f; }, 17);
  EXPECT_FALSE(none);
  EXPECT_EQ(proposed, 17);
}

}  // namespace
}  // namespace lambert
