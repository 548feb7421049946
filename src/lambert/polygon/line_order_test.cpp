#include "lambert/polygon/line_order.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert::polygon {
namespace {

// rows: PG-60
TEST(LineOrder, IsExactWhereEdgesCrossNearTheLine) {
  for (const double size : {1.0, 0x1p500, 0x1p-500, 0x1p1020, 0x1p-950}) {
    // Two edges that cross each other in (0, 0), then the same lines beside it by next to nothing.
    const double tiny = 0x1p-60;
    const auto compare = [&](double height, const LinePlace& p, const LinePlace& q) {
      return LineOrder(size * Vec2d(-1, height), size * Vec2d(1, height)).compare(p, q);
    };
    const LinePlace falling{.right = size * Vec2d(1, -1), .left = size * Vec2d(-1, 1)};
    const LinePlace rising{.right = size * Vec2d(-1, -1), .left = size * Vec2d(1, 1)};
    EXPECT_EQ(compare(0, falling, rising), 0);
    EXPECT_EQ(compare(tiny, falling, rising), -1);
    EXPECT_EQ(compare(tiny, rising, falling), 1);
    EXPECT_EQ(compare(-tiny, falling, rising), 1);
    EXPECT_EQ(compare(-tiny, rising, falling), -1);
  }
}

TEST(LineOrder, PlacesAreRightAtAnySize) {
  for (const double size : {1.0, 0x1p500, 0x1p-500, 0x1p1020, 0x1p-1000}) {
    const LineOrder order(size * Vec2d(0, 0), size * Vec2d(3, 3));
    const LinePlace crossing{.right = size * Vec2d(2, 0), .left = size * Vec2d(0, 1)};
    EXPECT_NEAR(order.parameter(crossing), 2.0 / 9, 1e-15);
    EXPECT_NEAR(order.point(crossing).x / size, 2.0 / 3, 1e-15);
    EXPECT_EQ(order.parameter({size * Vec2d(2, 2), size * Vec2d(2, 2)}), 2.0 / 3);
  }
}

}  // namespace
}  // namespace lambert::polygon
