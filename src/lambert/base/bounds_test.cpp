#include "lambert/base/bounds.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TEST(Bounds3, IsEmptyUntilSomethingIsAdded) {
  Bounds3 box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.radius(), 0);
  EXPECT_FALSE(box.contains(Vec3(0)));
  box.add(Vec3(1, 2, 3));
  EXPECT_FALSE(box.empty());
  EXPECT_TRUE(box.contains({1, 2, 3}));
  EXPECT_EQ(box.diagonal(), Vec3(0));
}

TEST(Bounds3, AddingTheEmptyBoxChangesNothing) {
  Bounds3 box{{0, 0, 0}, {1, 1, 1}};
  box.add(Bounds3{});
  EXPECT_EQ(box, (Bounds3{{0, 0, 0}, {1, 1, 1}}));
  box.add(Bounds3{{-1, 0.5f, 0}, {0, 3, 0}});
  EXPECT_EQ(box, (Bounds3{{-1, 0, 0}, {1, 3, 1}}));
}

TEST(Bounds3, CentreRadiusAndCorners) {
  const Bounds3 box{{-1, 0, 2}, {1, 4, 6}};
  EXPECT_EQ(box.centre(), Vec3(0, 2, 4));
  EXPECT_EQ(box.radius(), 3);
  Bounds3 again;
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(box.contains(box.corner(i)));
    EXPECT_NEAR(length(box.corner(i) - box.centre()), 3, 1e-6);
    again.add(box.corner(i));
  }
  EXPECT_EQ(again, box);
}

}  // namespace
}  // namespace lambert
