#include "lambert/polygon/predicates/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>

namespace lambert::polygon {
namespace {

using Integer = __int128;

int sign_of(Integer i) { return (i > 0) - (i < 0); }

/// A point whose coordinates are integers times 2^-53; the integers have at most 53 significant bits.
struct GridPoint {
  std::int64_t x, y;
  explicit operator Vec2d() const { return {0x1p-53 * static_cast<double>(x), 0x1p-53 * static_cast<double>(y)}; }
};

int exact_turn(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  return sign_of(static_cast<Integer>(b.x - a.x) * (d.y - c.y) - static_cast<Integer>(b.y - a.y) * (d.x - c.x));
}
int exact_orientation(GridPoint a, GridPoint b, GridPoint c) { return exact_turn(a, b, a, c); }
int exact_dot(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  return sign_of(static_cast<Integer>(b.x - a.x) * (d.x - c.x) + static_cast<Integer>(b.y - a.y) * (d.y - c.y));
}

constexpr std::int64_t one = std::int64_t{1} << 53;

// The classroom example of Kettner and others (2008): the rounded determinant is wrong in whole areas of this grid.
// rows: PG-10 PG-43
TEST(Orientation, IsExactAUnitAwayFromALine) {
  const GridPoint b{12 * one, 12 * one}, c{24 * one, 24 * one};
  int rounded_wrong = 0;
  for (std::int64_t i = 0; i < 256; ++i)
    for (std::int64_t j = 0; j < 256; ++j) {
      const GridPoint a{one / 2 + i, one / 2 + j};
      const int truth = exact_orientation(a, b, c);
      ASSERT_EQ(orientation(Vec2d(a), Vec2d(b), Vec2d(c)), truth);
      ASSERT_EQ(orientation(Vec2d(b), Vec2d(c), Vec2d(a)), truth);
      ASSERT_EQ(orientation(Vec2d(b), Vec2d(a), Vec2d(c)), -truth);
      ASSERT_EQ(exact::orientation(Vec2d(a), Vec2d(b), Vec2d(c)), truth);
      const double d = cross(Vec2d(a), Vec2d(b), Vec2d(c));
      rounded_wrong += (d > 0) - (d < 0) != truth;
    }
  EXPECT_GT(rounded_wrong, 1000) << "the example is not hard enough to test anything";
}

std::int64_t below(std::mt19937_64& random, std::int64_t limit) {
  return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(limit));
}

/// Four points on a line through (about) p with a short direction, each moved by at most a unit.
std::array<GridPoint, 4> near_line(std::mt19937_64& random) {
  const GridPoint p{below(random, one), below(random, one)};
  const GridPoint direction{below(random, 2001) - 1000, below(random, 2001) - 1000};
  std::array<GridPoint, 4> points;
  for (GridPoint& q : points) {
    const std::int64_t k = below(random, std::int64_t{1} << 42) - (std::int64_t{1} << 41);
    // Halved where they would need more than 53 bits: still a grid of units of 2.
    q = {p.x + k * direction.x, p.y + k * direction.y};
    q.x = (q.x >> 8 << 8) + (below(random, 3) - 1) * 256;
    q.y = (q.y >> 8 << 8) + (below(random, 3) - 1) * 256;
  }
  return points;
}

// rows: PG-10 PG-13
TEST(Predicates, AgreeWithIntegersNearDegeneracy) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 50000; ++i) {
    const auto [a, b, c, d] = near_line(random);
    const Vec2d p(a), q(b), r(c), s(d);
    ASSERT_EQ(orientation(p, q, r), exact_orientation(a, b, c));
    ASSERT_EQ(turn_sign(p, q, r, s), exact_turn(a, b, c, d));
    ASSERT_EQ(turn_sign(r, s, p, q), -exact_turn(a, b, c, d));
    // A quarter turn makes nearly parallel directions nearly orthogonal.
    const GridPoint e{-c.y, c.x}, f{-d.y, d.x};
    ASSERT_EQ(dot_sign(p, q, Vec2d(e), Vec2d(f)), exact_dot(a, b, e, f));
    ASSERT_EQ(dot_sign(p, q, Vec2d(f), Vec2d(e)), -exact_dot(a, b, e, f));
  }
}

TEST(Predicates, AreZeroOnExactDegeneraciesOfAnyScale) {
  for (const double scale : {1.0, 0x1p-190, 0x1p190, 0.1}) {
    const Vec2d a = scale * Vec2d(3, 1), b = scale * Vec2d(9, 3), c = scale * Vec2d(-12, -4);
    // 0.1 times 3 and 1 is rounded: then the points need not be collinear, but must be so in every order.
    if (scale != 0.1) {
      EXPECT_EQ(orientation(a, b, c), 0);
    }
    EXPECT_EQ(orientation(a, b, c), orientation(b, c, a));
    EXPECT_EQ(orientation(a, b, c), -orientation(a, c, b));
    EXPECT_EQ(orientation(a, a, c), 0);
    EXPECT_EQ(dot_sign(a, a, b, c), 0);
    EXPECT_EQ(turn_sign(a, b, b, b), 0);
  }
}

TEST(Between, IsTheClosedSegment) {
  const Vec2d a(0, 0), b(4, 2);
  EXPECT_TRUE(on_segment(a, b, {2, 1}));
  EXPECT_TRUE(on_segment(a, b, a));
  EXPECT_TRUE(on_segment(b, a, a));
  EXPECT_FALSE(on_segment(a, b, {6, 3}));
  EXPECT_FALSE(on_segment(a, b, {2, std::nextafter(1.0, 2.0)}));
  EXPECT_TRUE(on_segment({1, 0}, {1, 5}, {1, 5}));
  EXPECT_FALSE(on_segment({1, 0}, {1, 5}, {1, -1}));
  EXPECT_TRUE(on_segment(a, a, a));
  EXPECT_FALSE(on_segment(a, a, b));
}

int exact_in_circle(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  const Integer px = a.x - d.x, py = a.y - d.y, qx = b.x - d.x, qy = b.y - d.y, rx = c.x - d.x, ry = c.y - d.y;
  return sign_of((px * px + py * py) * (qx * ry - rx * qy) + (qx * qx + qy * qy) * (rx * py - px * ry) +
                 (rx * rx + ry * ry) * (px * qy - qx * py));
}

// Circles through many integer points: x^2 + y^2 = 5^2 13^2 17^2.
std::vector<GridPoint> cocircular() {
  constexpr std::int64_t radius = 1105;
  std::vector<GridPoint> points;
  for (std::int64_t x = -radius; x <= radius; ++x)
    for (std::int64_t y = -radius; y <= radius; ++y)
      if (x * x + y * y == radius * radius) points.push_back({x, y});
  return points;
}

TEST(InCircle, AgreesWithIntegersOnAndBesideCircles) {
  const std::vector<GridPoint> circle = cocircular();
  ASSERT_GE(circle.size(), 100u);
  std::mt19937_64 random(11);
  int on = 0;
  for (int i = 0; i < 20000; ++i) {
    const GridPoint centre{below(random, 1 << 26), below(random, 1 << 26)};
    std::array<GridPoint, 4> p;
    for (GridPoint& q : p) {
      q = circle[random() % circle.size()];
      q = {centre.x + q.x, centre.y + q.y};
    }
    if (i % 2) p[random() % 4].x += below(random, 3) - 1;
    const int truth = exact_in_circle(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(in_circle(Vec2d(p[0]), Vec2d(p[1]), Vec2d(p[2]), Vec2d(p[3])), truth);
    ASSERT_EQ(in_circle(Vec2d(p[1]), Vec2d(p[0]), Vec2d(p[2]), Vec2d(p[3])), -truth);
    ASSERT_EQ(in_circle(Vec2d(p[1]), Vec2d(p[2]), Vec2d(p[3]), Vec2d(p[0])), -truth);
    on += truth == 0;
  }
  EXPECT_GT(on, 5000);
}

TEST(InCircle, SeesOneUnitInTheLastPlace) {
  // All four lie on the circle about the origin of radius 5 * 2^40, moved far away from it where the grid is coarse.
  const Vec2d far(0x1p52, -0x1p52);
  const auto at = [&](double x, double y) { return far + Vec2d(x, y); };
  const Vec2d a = at(4, 3), b = at(-3, 4), c = at(-4, -3), on = at(3, -4);
  EXPECT_EQ(in_circle(a, b, c, on), 0);
  EXPECT_EQ(in_circle(a, b, c, {on.x - 1, on.y}), 1);
  EXPECT_EQ(in_circle(a, b, c, {on.x + 1, on.y}), -1);
  EXPECT_EQ(in_circle(a, b, c, {on.x, std::nextafter(on.y, 0.0)}), 1);
  EXPECT_EQ(in_circle(a, b, c, a), 0);
}

}  // namespace
}  // namespace lambert::polygon
