#include "lambert/polygon/queries/pick.h"

#include <gtest/gtest.h>

namespace lambert::polygon {
namespace {

// rows: PG-41 PG-40
TEST(GravityField, IsTwoDisksAndARectangleOfFullWidth) {
  const GravityField field{2, 1};
  const Vec2d a(0, 0), b(10, 0);
  EXPECT_TRUE(is_picked(field, a, b, {5, 0.5}));
  EXPECT_FALSE(is_picked(field, a, b, {5, 0.75}));
  EXPECT_TRUE(is_picked(field, a, b, {1, 1.5})) << "in the disk, beside the rectangle";
  EXPECT_FALSE(is_picked(field, a, b, {-2, 0}));
  EXPECT_TRUE(is_picked(field, a, b, {11, -1}));
  EXPECT_TRUE(is_picked(field, a, a, {1, 1})) << "a point has only its disk";
  EXPECT_FALSE(is_picked(field, a, a, {2, 1}));
}

// rows: PG-41
TEST(GravityField, FollowsTheWindowToViewportScale) {
  const Box2 viewport{{0, 0}, {800, 400}};
  const GravityField even = field_of_pixels(8, 4, {{-1, -0.5}, {3, 1.5}}, viewport);
  EXPECT_DOUBLE_EQ(even.radius, 8 * 4.0 / 800);
  EXPECT_DOUBLE_EQ(even.width, 4 * 4.0 / 800);
  const GravityField stretched = field_of_pixels(8, 4, {{0, 0}, {4, 4}}, viewport);
  EXPECT_DOUBLE_EQ(stretched.radius, 8 * 4.0 / 400);
  // Zoomed in ten times, the same pointer reaches a tenth as far.
  const GravityField near = field_of_pixels(8, 4, {{0, 0}, {0.4, 0.2}}, viewport);
  EXPECT_TRUE(is_picked(even, {0, 0}, {1, 0}, {0.5, 0.009}));
  EXPECT_FALSE(is_picked(near, {0, 0}, {1, 0}, {0.5, 0.009}));
}

// rows: PG-41
TEST(PickedEdge, IsTheNearest) {
  const Ring ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const GravityField field{2, 1};
  EXPECT_EQ(picked_edge(field, ring, {5, 0.25}), 0u);
  EXPECT_EQ(picked_edge(field, ring, {-0.25, 5}), 3u);
  EXPECT_EQ(picked_edge(field, ring, {9.5, 1}), 1u) << "both disks of the corner catch it, the edge at 0.5 is nearer";
  EXPECT_FALSE(picked_edge(field, ring, {5, 5}));
  EXPECT_FALSE(picked_edge(field, {}, {5, 5}));
}

}  // namespace
}  // namespace lambert::polygon
