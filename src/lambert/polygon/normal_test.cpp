#include "lambert/polygon/normal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace lambert::polygon {
namespace {

using Face = std::vector<Vec3d>;

void expect_near(Vec3d a, Vec3d b, double tolerance = 1e-14) { EXPECT_LT(length(a - b), tolerance); }

// rows: PG-16
TEST(PlaneNormal, IsOfUnitLengthAtAnySize) {
  for (const double s : {1.0, 1e-200, 1e200}) expect_near(*plane_normal(2 * s, -3 * s, 6 * s), Vec3d(2, -3, 6) / 7.0);
  EXPECT_FALSE(plane_normal(0, 0, 0));
}

// rows: PG-17
TEST(ThreeVertexNormal, PassesOverCollinearTriples) {
  const Face face{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 1, 0}};
  expect_near(*three_vertex_normal(face), normalize(Vec3d(-1, 0, 1)));
  EXPECT_FALSE(three_vertex_normal(Face{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {-1, -2, -3}}));
  EXPECT_FALSE(three_vertex_normal(Face{}));
  EXPECT_FALSE(three_vertex_normal(Face{{1, 1, 1}, {1, 1, 1}}));
  // One unit in the last place makes a plane.
  const double above = std::nextafter(1.5, 2.0);
  EXPECT_TRUE(three_vertex_normal(Face{{0, 0, 0}, {3, 3, 3}, {1.5, 1.5, above}}));
}

// rows: PG-18
TEST(NewellNormal, IsMissingForTwoReasons) {
  const Face bow_tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, line{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  EXPECT_FALSE(newell_normal(bow_tie));
  EXPECT_FALSE(on_one_line(bow_tie));
  EXPECT_FALSE(newell_normal(line));
  EXPECT_TRUE(on_one_line(line));
}

// rows: PG-17 PG-18
TEST(ThreeVertexNormal, IsReversedWhereTheFirstCornerIsReflex) {
  const Face arrow{{0, 4, 0}, {1, 1, 0}, {4, 0, 0}, {0, 0, 0}};  // clockwise; it turns left at (1, 1)
  expect_near(*newell_normal(arrow), {0, 0, -1});
  expect_near(*three_vertex_normal(arrow), {0, 0, 1});
}

// rows: PG-18
TEST(NewellNormal, IsTwiceTheAreaWhereverTheFaceLies) {
  const Face square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(newell_sum(square), Vec3d(0, 0, 2));
  Face far;
  for (const Vec3d v : square) far.push_back(v + Vec3d(1e15, -1e15, 1e15));
  EXPECT_EQ(newell_sum(far), Vec3d(0, 0, 2));
  EXPECT_FALSE(newell_normal(Face{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(newell_normal(Face{}));
}

// rows: PG-19
TEST(Planarity, IsAnAngle) {
  const double lift = 1e-3;
  for (const double s : {1.0, 1e-100, 1e100}) {
    const Face bent{s * Vec3d(0, 0, lift), s * Vec3d(1, 0, -lift), s * Vec3d(1, 1, lift), s * Vec3d(0, 1, -lift)};
    EXPECT_NEAR(out_of_plane_sine(bent), 2 * lift, 1e-8) << "does not depend on size";
    EXPECT_FALSE(is_planar(bent));
    EXPECT_TRUE(is_planar(bent, 3e-3));
  }
  EXPECT_TRUE(is_planar(Face{{0, 0, 1}, {3, 0, 1}, {3, 0, 1}, {0, 2, 1}}));
  EXPECT_FALSE(is_planar(Face{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}})) << "no plane at all";
}

// rows: PG-18 PG-67
TEST(PlaneProjection, KeepsCounterClockwiseFacesSo) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  const auto direction = [&] { return normalize(Vec3d(normal(random), normal(random), normal(random))); };
  for (int i = 0; i < 1000; ++i) {
    const Vec3d n = direction(), u = normalize(cross(n, direction())), v = cross(n, u);
    const Face face{u, v, -u, -v + 0.1 * u};
    const PlaneProjection project(n);
    const double shrink = std::abs(n[project.axis()]);
    EXPECT_GE(shrink, 0.577);
    EXPECT_NEAR(signed_area(project(face)), shrink * 0.5 * length(newell_sum(face)), 1e-12);
  }
  EXPECT_EQ(dominant_axis({1, -3, 2}), 1);
  EXPECT_EQ(PlaneProjection({0, 0, 1})(Vec3d(1, 2, 3)), Vec2d(1, 2));
  EXPECT_EQ(PlaneProjection({0, 0, -1})(Vec3d(1, 2, 3)), Vec2d(2, 1));
}

}  // namespace
}  // namespace lambert::polygon
