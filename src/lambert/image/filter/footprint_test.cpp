#include "lambert/image/filter/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

// rows: AA-21
TEST(Footprint, DIsTheLargestEdge) {
  EXPECT_EQ(largest_edge(Footprint{{3, 4}, {1, 2}}), 5);
  EXPECT_EQ(largest_edge(Footprint{{1, 2}, {-3, 4}}), 5);
  // The parallelogram that those derivatives span, and one whose far edge is the longest.
  EXPECT_EQ(largest_edge({Vec2d(0, 0), Vec2d(3, 4), Vec2d(4, 6), Vec2d(1, 2)}), 5);
  EXPECT_EQ(largest_edge({Vec2d(0, 0), Vec2d(1, 0), Vec2d(6, 12), Vec2d(0, 1)}), 13);
}

TEST(Footprint, LevelIsItsLogarithmClamped) {
  const LevelChoice five = level_for(5, 10);
  EXPECT_EQ(five.level, 2);
  EXPECT_NEAR(five.fraction, 0.321928094887, 1e-12);
  for (const double magnified : {0.0, 0.3, 1.0, -2.0, std::nan("")}) {
    EXPECT_EQ(level_for(magnified, 10).level, 0);
    EXPECT_EQ(level_for(magnified, 10).fraction, 0);
  }
  for (const double far : {8.0, 100.0, 1e300, HUGE_VAL}) {
    EXPECT_EQ(level_for(far, 4).level, 3);
    EXPECT_EQ(level_for(far, 4).fraction, 0);
  }
  EXPECT_EQ(level_for(100, 1).level, 0);
}

}  // namespace
}  // namespace lambert
