#include "lambert/polygon/queries/segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace lambert::polygon {
namespace {

/// A second way to the case, by rational arithmetic on small integers.
SegmentCase expected_case(const Segment& v, const Segment& w) {
  const Vec2d d = v.b - v.a, e = w.b - w.a, o = w.a - v.a;
  const double determinant = d.x * e.y - d.y * e.x;
  if (determinant != 0) {
    const double s = determinant > 0 ? 1 : -1, t = s * (o.x * e.y - o.y * e.x), p = s * (o.x * d.y - o.y * d.x);
    const double limit = s * determinant;
    return t >= 0 && t <= limit && p >= 0 && p <= limit ? SegmentCase::crossing : SegmentCase::lines_cross_outside;
  }
  if (d.x * o.y - d.y * o.x != 0 || e.x * o.y - e.y * o.x != 0) return SegmentCase::parallel_disjoint;
  const Vec2d along = d != Vec2d(0) ? d : (e != Vec2d(0) ? e : o);
  const auto place = [&](Vec2d q) { return dot(q, along); };
  const double low = std::max(std::min(place(v.a), place(v.b)), std::min(place(w.a), place(w.b)));
  const double high = std::min(std::max(place(v.a), place(v.b)), std::max(place(w.a), place(w.b)));
  if (v == w || (v.a == w.b && v.b == w.a)) return SegmentCase::superimposed;
  if (low > high) return SegmentCase::collinear_disjoint;
  return low < high ? SegmentCase::collinear_overlap : SegmentCase::collinear_touching;
}

Segment small(std::mt19937_64& random) {
  const auto c = [&] { return static_cast<double>(random() % 6); };
  const Vec2d a(c(), c()), b(c(), c());
  return {a, b};
}

// rows: PG-10 PG-11 PG-12
TEST(Intersect, KnowsEveryCaseOnASmallGrid) {
  std::mt19937_64 random(5);
  std::array<int, 7> seen{};
  for (int i = 0; i < 200000; ++i) {
    const Segment v = small(random), w = small(random);
    const SegmentMeeting m = intersect(v, w);
    ASSERT_EQ(name_of(m.kind), name_of(expected_case(v, w)))
        << v.a.x << ',' << v.a.y << ' ' << v.b.x << ',' << v.b.y << " with " << w.a.x << ',' << w.a.y << ' ' << w.b.x
        << ',' << w.b.y;
    ++seen[static_cast<std::size_t>(m.kind)];
    ASSERT_EQ(intersect(w, v).kind, m.kind);
    if (!m.meet()) continue;
    ASSERT_LT(length(v.at(m.t) - m.from), 1e-13);
    ASSERT_LT(length(w.at(m.p) - m.from), 1e-13);
    ASSERT_GE(std::min(m.t, m.p), 0);
    ASSERT_LE(std::max(m.t, m.p), 1);
    if (m.kind == SegmentCase::crossing) {
      ASSERT_EQ(m.from, m.to);
      ASSERT_EQ(intersect_half_open(v, w), m.t < 1 && m.p < 1);
    } else {
      ASSERT_FALSE(intersect_half_open(v, w));
      for (const Vec2d q : {m.from, m.to}) ASSERT_TRUE(on_segment(v.a, v.b, q) && on_segment(w.a, w.b, q));
      if (m.kind != SegmentCase::superimposed) {
        ASSERT_EQ(m.kind == SegmentCase::collinear_touching, m.from == m.to);
      }
    }
  }
  for (const int n : seen) EXPECT_GT(n, 100);
}

// rows: PG-11
TEST(IntersectHalfOpen, LosesTheJointOfAChainAndDependsOnDirection) {
  EXPECT_FALSE(intersect_half_open({{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}));
  EXPECT_FALSE(intersect_half_open({{0, 0}, {2, 0}}, {{1, 1}, {1, 0}}));
  EXPECT_TRUE(intersect_half_open({{0, 0}, {2, 0}}, {{1, 0}, {1, 1}}));
}

// rows: PG-12
TEST(Intersect, ComparesSignedPlacesOnALine) {
  const SegmentMeeting apart = intersect({{0, 0}, {2, 0}}, {{-3, 0}, {-1, 0}});
  EXPECT_EQ(apart.kind, SegmentCase::collinear_disjoint);
  EXPECT_EQ(signed_coordinate({0, 0}, {2, 0}, {-3, 0}), -3);
  EXPECT_EQ(signed_coordinate({0, 0}, {-2, 0}, {-3, 0}), 3);
}

// rows: PG-10
TEST(Intersect, FindsCrossingsOfNearlyParallelSegmentsToTheLastDigits) {
  // They cross at (k, 1), a unit in the last place away from being parallel; Cramer's rule alone loses every digit.
  const double unit = 0x1p-52;
  for (int k = 1; k < 1000; k += 7) {
    const Segment v{{0, 1}, {1000, 1}};
    const Segment w{{0, 1 - k * unit / 2}, {1000, 1 + (1000 - k) * unit}};
    const double rise = w.b.y - w.a.y, x = 1000 * (1 - w.a.y) / rise;  // both differences are exact
    const SegmentMeeting m = intersect(v, w);
    ASSERT_EQ(m.kind, SegmentCase::crossing);
    EXPECT_NEAR(m.from.x, x, 1e-12 * x);
    EXPECT_EQ(m.from.y, 1);
  }
}

// rows: PG-10
TEST(Intersect, DecidesExactlyByOneUnit) {
  const Segment v{{0, 0}, {3, 1}};
  const Vec2d foot(1.5, 0.5), above(1.5, std::nextafter(0.5, 1.0)), top(1, 2);
  EXPECT_EQ(intersect(v, {foot, top}).kind, SegmentCase::crossing);
  EXPECT_EQ(intersect(v, {foot, top}).from, foot);
  EXPECT_EQ(intersect(v, {above, top}).kind, SegmentCase::lines_cross_outside);
}

// rows: PG-10 PG-12
TEST(Intersect, ServesCoordinatesOfAnySize) {
  for (const double s : {1e-300, 1e-150, 1e150, 1e300}) {
    const SegmentMeeting m = intersect({s * Vec2d(0, 0), s * Vec2d(4, 4)}, {s * Vec2d(0, 4), s * Vec2d(4, 0)});
    EXPECT_EQ(m.kind, SegmentCase::crossing);
    EXPECT_NEAR(m.from.x, 2 * s, 1e-12 * s);
    EXPECT_EQ(m.t, 0.5);
    const SegmentMeeting o = intersect({s * Vec2d(0, 0), s * Vec2d(4, 0)}, {s * Vec2d(2, 0), s * Vec2d(8, 0)});
    EXPECT_EQ(o.kind, SegmentCase::collinear_overlap);
    EXPECT_EQ(o.to, s * Vec2d(4, 0));
  }
}

// rows: PG-08
TEST(Segment, ReachesItsEnd) {
  const Segment s{{0.1, 1e9}, {0.3, -1}};
  EXPECT_EQ(s.at(0), s.a);
  EXPECT_EQ(s.at(1), s.b);
}

// rows: PG-13
TEST(Orthogonal, IsExact) {
  EXPECT_TRUE(orthogonal({{1, 1}, {4, 3}}, {{0, 0}, {-2, 3}}));
  EXPECT_FALSE(orthogonal({{1, 1}, {4, 3}}, {{0, 0}, {-2, std::nextafter(3.0, 4.0)}}));
}

// rows: PG-42
TEST(FootOfPerpendicular, WorksInSpaceAndGuardsPoints) {
  const auto foot = foot_of_perpendicular(Vec3d(1, 0, 0), Vec3d(1, 0, 4), Vec3d(4, 4, 1));
  ASSERT_TRUE(foot);
  EXPECT_EQ(foot->t, 0.25);
  EXPECT_EQ(foot->point, Vec3d(1, 0, 1));
  EXPECT_EQ(foot->distance, 5);
  EXPECT_FALSE(foot_of_perpendicular(Vec2d(1, 1), Vec2d(1, 1), Vec2d(0, 0)));
  EXPECT_EQ(distance_to_segment(Vec2d(1, 1), Vec2d(1, 1), Vec2d(4, 5)), 5);
  EXPECT_EQ(distance_to_segment(Vec2d(0, 0), Vec2d(4, 0), Vec2d(7, 4)), 5);
  EXPECT_EQ(distance_to_segment(Vec2d(0, 0), Vec2d(4, 0), Vec2d(2, -3)), 3);
  EXPECT_EQ(foot_of_perpendicular(Vec2d(0, 0), Vec2d(4, 2), Vec2d(4, 2))->t, 1);
}

}  // namespace
}  // namespace lambert::polygon
