#include "lambert/polygon/queries/lerp.h"

#include "lambert/base/vec.h"

#include <gtest/gtest.h>

#include <random>

namespace lambert::polygon {
namespace {

// rows: PG-08
TEST(Lerp, BothFormsMeetBothEndsExactly) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-30, 30);
  const auto coordinate = [&] { return std::exp2(exponent(random)) * (random() % 2 ? 1 : -1); };
  bool sum_alone_misses = false;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d a(coordinate(), coordinate(), coordinate()), b(coordinate(), coordinate(), coordinate());
    EXPECT_EQ(lerp(a, b, 0), a);
    EXPECT_EQ(lerp(a, b, 1), b);
    EXPECT_EQ(weighted(a, b, 0), a);
    EXPECT_EQ(weighted(a, b, 1), b);
    sum_alone_misses = sum_alone_misses || a + (b - a) != b;
    const double t = 0.375, size = length(a) + length(b);
    EXPECT_NEAR(length(lerp(a, b, t) - weighted(a, b, t)), 0, 1e-15 * size);
  }
  EXPECT_TRUE(sum_alone_misses) << "the test never met the case that needs care";
}

// rows: PG-09
TEST(ParameterSteps, IncludeBothEnds) {
  EXPECT_EQ(parameter_steps(0.0, 90.0, 4), (std::vector<double>{0, 22.5, 45, 67.5, 90}));
  EXPECT_EQ(parameter_steps(5.0, 7.0, 0), std::vector<double>{5});
  EXPECT_EQ(parameter_steps(5.0, 7.0, 1), (std::vector<double>{5, 7}));
  const auto points = parameter_steps(Vec2d(0.1, 1), Vec2d(0.7, -1), 3);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[3], Vec2d(0.7, -1));
}

}  // namespace
}  // namespace lambert::polygon
