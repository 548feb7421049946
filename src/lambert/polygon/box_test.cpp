#include "lambert/polygon/box.h"

#include <gtest/gtest.h>

#include <vector>

namespace lambert::polygon {
namespace {

// rows: PG-46
TEST(Box2, IsEmptyUntilSomethingIsAdded) {
  Box2 box;
  EXPECT_TRUE(box.empty());
  EXPECT_FALSE(box.contains({0, 0}));
  EXPECT_EQ(box.size(), Vec2d(0));
  EXPECT_EQ(box_of(Ring{}), box);
  box.add({3, -1});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.min, box.max);
  EXPECT_TRUE(box.contains({3, -1}));
}

// rows: PG-46
TEST(Box2, SeesEveryVertex) {
  const Rings rings{{{0, 0}, {5, 1}, {-3, 2}, {1, 1}}, {}, {{2, -7}}};
  const Box2 box = box_of(rings);
  EXPECT_EQ(box.min, Vec2d(-3, -7));
  EXPECT_EQ(box.max, Vec2d(5, 2));
  EXPECT_EQ(box.centre(), Vec2d(1, -2.5));
}

TEST(Box2, OverlapsWhereBoundariesTouch) {
  const Box2 a{{0, 0}, {2, 2}};
  EXPECT_TRUE(a.overlaps({{2, 2}, {3, 3}}));
  EXPECT_TRUE(a.overlaps({{1, -1}, {1, 3}}));
  EXPECT_FALSE(a.overlaps({{2.5, 0}, {3, 3}}));
  EXPECT_FALSE(a.overlaps({{0, 2.5}, {3, 3}}));
  EXPECT_FALSE(a.overlaps(Box2{}));
}

}  // namespace
}  // namespace lambert::polygon
