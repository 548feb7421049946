#include "lambert/geometry/ray_tests.h"

#include "lambert/geometry/shape_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

// rows: PG-61 PG-62
TEST(LinePlane, ImplicitForm) {  // V-PG-42
  const PlaneMeeting met = line_plane({0, 0, 0}, {1, 1, 1}, 1, 2, 2, -9);
  ASSERT_TRUE(std::holds_alternative<double>(met));
  EXPECT_NEAR(std::get<double>(met), 1.8, 1e-12);
}

// rows: PG-62 PG-63
TEST(LinePlane, BothFormsAgreeAndMeetThePlane) {  // E-PG-21
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p1(random.cube(5)), p2(random.cube(5)), s(random.cube(5)), n(random.direction());
    const PlaneMeeting a = line_plane(p1, p2, s, n), b = line_plane(p1, p2, n.x, n.y, n.z, -glm::dot(n, s));
    ASSERT_TRUE(std::holds_alternative<double>(a) && std::holds_alternative<double>(b));
    const double t = std::get<double>(a);
    EXPECT_NEAR(t, std::get<double>(b), 1e-9 * (1 + std::abs(t)));
    EXPECT_NEAR(glm::dot(n, p1 + t * (p2 - p1) - s), 0, 1e-10 * (1 + std::abs(t)));
  }
}

// rows: PG-63
TEST(LinePlane, ParallelLinesMissOrLieInThePlane) {
  const Vec3d s(0, 0, 2), n(0, 0, 1);
  EXPECT_TRUE(std::holds_alternative<NoMeeting>(line_plane({0, 0, 0}, {1, 1, 0}, s, n)));
  EXPECT_TRUE(std::holds_alternative<LiesInPlane>(line_plane({0, 0, 2}, {1, 1, 2}, s, n)));
}

// rows: PG-63
TEST(LinePlane, RangesOfRayAndSegment) {
  EXPECT_TRUE(on_ray(0) && on_ray(7) && !on_ray(-0.1));
  EXPECT_TRUE(on_segment(0) && on_segment(1) && !on_segment(1.1) && !on_segment(-0.1));
}

// rows: PG-64 PG-65
TEST(RayTriangle, WorkedExample) {  // V-PG-44
  const Vec3d a(0, 0, 0), b(4, 0, 0), c(0, 4, 0), origin(1, 1, 5), direction(0, 0, -1);
  const auto t = ray_triangle(origin, direction, a, b, c);
  ASSERT_TRUE(t);
  EXPECT_NEAR(*t, 5, 1e-12);
  const Vec3d s = barycentric_by_areas(origin + *t * direction, a, b, c);
  EXPECT_LT(glm::length(s - Vec3d(0.5, 0.25, 0.25)), 1e-12);
  EXPECT_FALSE(ray_triangle(origin, -direction, a, b, c));
  EXPECT_FALSE(ray_triangle({2.5, 2.5, 5}, direction, a, b, c));
}

// rows: PG-65
TEST(Barycentric, AreasWithoutSignAddUpToMoreThanOneOutside) {  // E-PG-22
  const Vec3d a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const Vec3d s = barycentric_by_areas({2.5, 2.5, 0}, a, b, c);
  EXPECT_LT(glm::length(s - Vec3d(0.25, 0.625, 0.625)), 1e-12);
  EXPECT_FALSE(inside_by_areas({2.5, 2.5, 0}, a, b, c));
  EXPECT_TRUE(inside_by_areas({0.1, 0.2, 0}, a, b, c));
}

// rows: PG-65
TEST(Barycentric, PointIsTheWeightedSumOfTheCorners) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec3d a(random.cube(2)), b(random.cube(2)), c(random.cube(2));
    const Vec2d w(square_to_triangle(random.square()));
    const Vec3d p = a + w.x * (b - a) + w.y * (c - a), s = barycentric_by_areas(p, a, b, c);
    EXPECT_LT(glm::length(s.x * a + s.y * b + s.z * c - p), 1e-9);
    EXPECT_TRUE(inside_by_areas(p, a, b, c));
  }
}

// rows: PG-66
TEST(TriangleArea, ByThreeDeterminants) {  // V-PG-46
  EXPECT_NEAR(triangle_area({1, 0, 2}, {4, -1, 3}, {0, 5, 1}), 7.34846922835, 1e-11);
  // E-PG-23: of (y, z) = (1, 2), (4, -1), (3, 5) alone the determinant is 15.
  EXPECT_NEAR(triangle_area({0, 1, 2}, {0, 4, -1}, {0, 3, 5}), 7.5, 1e-12);
}

// rows: PG-67
TEST(InsidePolygon, HalfLineCrossings) {
  const std::vector<Vec3> notched = {{5, -1, -1}, {5, 3, -1}, {5, 0, 0}, {5, -1, 3}};  // V-PG-47
  EXPECT_TRUE(inside_projected_polygon({5, -0.5, -0.5}, notched, 0));
  EXPECT_FALSE(inside_projected_polygon({5, 1, 1}, notched, 0));
}

}  // namespace
}  // namespace lambert
