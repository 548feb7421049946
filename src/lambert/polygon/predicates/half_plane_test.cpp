#include "lambert/polygon/predicates/half_plane.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert::polygon {
namespace {

// rows: PG-43
TEST(SideOfLine, IsExactAndFollowsTheLinesDirection) {
  EXPECT_EQ(side_of_line({0, 0}, {3, 1}, {6, 2}), Side::on);
  EXPECT_EQ(side_of_line({0, 0}, {3, 1}, {6, std::nextafter(2.0, 3.0)}), Side::left);
  EXPECT_EQ(side_of_line({3, 1}, {0, 0}, {6, std::nextafter(2.0, 3.0)}), Side::right);
  EXPECT_EQ(side_of_line({1, 1}, {1, 1}, {6, 2}), Side::on);
}

// rows: PG-43
TEST(HalfPlaneCross, IsPositiveToTheRight) {
  EXPECT_EQ(half_plane_cross({1, 1}, {1, 4}, {3, 0}), 6) << "the distance 2 times the length 3";
  EXPECT_EQ(half_plane_cross({1, 1}, {1, 4}, {-1, 9}), -6);
  EXPECT_EQ(half_plane_cross({1, 4}, {1, 1}, {3, 0}), -6);
}

}  // namespace
}  // namespace lambert::polygon
