#include "lambert/polygon/arrangement/crossing.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <random>

namespace lambert::polygon::arrangement {
namespace {

/// With 64 bits of mantissa.
long double distance_to_line(Segment s, Vec2d p) {
  const long double x = static_cast<long double>(s.b.x) - s.a.x, y = static_cast<long double>(s.b.y) - s.a.y;
  const long double px = static_cast<long double>(p.x) - s.a.x, py = static_cast<long double>(p.y) - s.a.y;
  return std::abs(x * py - y * px) / std::hypot(x, y);
}

TEST(CrossingPoint, LiesOnBothLinesHoweverFlatTheyCross) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int crossings = 0;
  for (int i = 0; i < 200'000; ++i) {
    // Angles down to what doubles can tell apart, anywhere along the segments.
    const double flat = std::pow(2.0, -52 * std::abs(uniform(random)));
    const Segment s{{uniform(random), uniform(random)}, {uniform(random), uniform(random)}};
    const Vec2d along = s.b - s.a, across = flat * Vec2d(-along.y, along.x);
    const Vec2d middle = s.a + (0.5 + 0.5 * uniform(random)) * along;
    const Segment t{middle - std::abs(uniform(random)) * along - uniform(random) * across,
                    middle + std::abs(uniform(random)) * along + uniform(random) * across};
    if (!segments_cross(s, t)) continue;
    ++crossings;
    const Vec2d p = crossing_point(s, t);
    ASSERT_TRUE(in_box(s, p) && in_box(t, p));
    ASSERT_LE(distance_to_line(s, p), 0x1p-48L);
    ASSERT_LE(distance_to_line(t, p), 0x1p-48L);
    ASSERT_EQ(crossing_point(t, s), p);
    ASSERT_EQ(crossing_point({s.b, s.a}, {t.b, t.a}), p);
  }
  EXPECT_GT(crossings, 50'000);
}

TEST(Grid, RoundsBelowItsLimitOnly) {
  const Grid grid(0.25);
  EXPECT_EQ(grid(0.3), 0.25);
  EXPECT_EQ(grid(-0.9), -1);
  EXPECT_EQ(grid(0.125), 0);
  EXPECT_EQ(grid(0x1p60 + 0x1p10), 0x1p60 + 0x1p10);
  EXPECT_EQ(Grid()(1.0 / 3), 1.0 / 3);
}

}  // namespace
}  // namespace lambert::polygon::arrangement
