#include "lambert/base/error.h"
#include "lambert/geometry/shape_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

// rows: PG-67
TEST(Polygon, WorkedExample) {  // V-PG-47
  const Polygon polygon({{5, -1, -1}, {5, 3, -1}, {5, 0, 0}, {5, -1, 3}});
  const Vec3 origin(0, -0.5f, -0.5f);
  const auto hit = polygon.intersect({.origin = origin, .direction = {1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 5);
  EXPECT_EQ(hit->normal, Vec3(1, 0, 0));
  // The plane is met at t = 5 in (5, 1, 1), in the notch.
  EXPECT_FALSE(polygon.intersect({.origin = origin, .direction = {1, 0.3f, 0.3f}}));
}

// rows: PG-67
TEST(Polygon, EveryAxisMayBeDropped) {
  const std::vector<Vec2> outline = {{0, 0}, {2, 0}, {2, 2}, {1, 0.5f}, {0, 2}};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Vec3> corners;
    for (const Vec2 p : outline) {
      Vec3 corner(0);
      corner[(axis + 1) % 3] = p.x, corner[(axis + 2) % 3] = p.y, corner[axis] = 0.1f * p.x;
      corners.push_back(corner);
    }
    const Polygon polygon(corners);
    Vec3 d(0), inside(0), notch(0);
    d[axis] = 1;
    inside[(axis + 1) % 3] = 0.2f, inside[(axis + 2) % 3] = 1;
    notch[(axis + 1) % 3] = 1, notch[(axis + 2) % 3] = 1;
    EXPECT_TRUE(polygon.intersect({.origin = inside - d, .direction = d}));
    EXPECT_FALSE(polygon.intersect({.origin = notch - d, .direction = d}));
    EXPECT_NEAR(polygon.normal()[axis], 1, 0.01);
    EXPECT_NEAR(polygon.area(), (4 - 1.5f) * std::sqrt(1.01f), 1e-5);
  }
}

TEST(Polygon, RayInItsPlaneMisses) {
  const Polygon square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  EXPECT_FALSE(square.intersect({.origin = {-1, 0.5f, 0}, .direction = {1, 0, 0}}));
}

TEST(Polygon, RefusesWhatIsNoPlanarPolygon) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(Polygon({{0, 0, 0}, {1, 0, 0}}), Error);
  EXPECT_THROW(Polygon({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), Error);
  EXPECT_THROW(Polygon({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}), Error);
  EXPECT_THROW(Polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5f}, {0, 1, 0}}), Error);
  EXPECT_THROW(Polygon({{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}}), Error);
}

TEST(Polygon, FarFromTheOriginItIsStillPlanar) {
  const Vec3 far(1e4f, -2e4f, 3e4f), s = normalize(Vec3(1, 2, 3)), t = normalize(cross(s, Vec3(0, 1, 0)));
  EXPECT_NEAR(Polygon({far, far + s, far + s + t, far + t}).area(), 1, 0.01);
}

}  // namespace
}  // namespace lambert
