#include "lambert/polygon/queries/convex.h"

#include "lambert/polygon/predicates/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace lambert::polygon {
namespace {

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Ring star(int tips, int step) {
  Ring ring;
  for (int i = 0; i < tips; ++i) {
    const double angle = 2 * std::numbers::pi * i * step / tips;
    ring.emplace_back(std::cos(angle), std::sin(angle));
  }
  return ring;
}

// rows: PG-15
TEST(TurningAngle, IsSignedAndInRadians) {
  EXPECT_DOUBLE_EQ(turning_angle({0, 0}, {1, 0}, {1, 1}), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(turning_angle({0, 0}, {1, 0}, {2, -1}), -std::numbers::pi / 4);
  EXPECT_EQ(turning_angle({0, 0}, {1, 0}, {3, 0}), 0);
  EXPECT_EQ(turning_angle({0, 0}, {1, 0}, {0.5, 0}), std::numbers::pi);
  EXPECT_EQ(turning_angle({0, 0}, {0, 0}, {3, 0}), 0);
  EXPECT_GT(turning_angle({0, 0}, {3, 1}, {6, std::nextafter(2.0, 3.0)}), 0);
}

// rows: PG-15
TEST(Revolutions, AreTheTotalTurning) {
  const Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, eight{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  EXPECT_EQ(revolutions(square), 1);
  EXPECT_EQ(revolutions(reversed(square)), -1);
  EXPECT_EQ(revolutions(eight), 0);
  EXPECT_EQ(revolutions(star(5, 2)), 2);
  EXPECT_EQ(revolutions(star(7, 3)), 3);
  EXPECT_EQ(revolutions({}), 0);
  EXPECT_EQ(revolutions({{1, 1}}), 0);
  EXPECT_EQ(revolutions({{1, 1}, {1, 1}, {1, 1}}), 0);
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    Ring ring(1 + random() % 8);
    for (Vec2d& p : ring) p = {static_cast<double>(random() % 4), static_cast<double>(random() % 4)};
    EXPECT_NEAR(total_turning(ring), 2 * std::numbers::pi * revolutions(ring), 1e-12);
  }
}

// rows: PG-15 PG-14
TEST(IsConvex, NeedsOneRevolution) {
  EXPECT_TRUE(turns_one_way(star(5, 2)));
  EXPECT_FALSE(is_convex(star(5, 2)));
  EXPECT_TRUE(is_convex(star(5, 1)));
  EXPECT_TRUE(is_convex(reversed(star(5, 1))));
  EXPECT_TRUE(is_convex({{0, 0}, {1, 0}, {0, 1}})) << "every triangle";
  EXPECT_FALSE(is_convex({{0, 0}, {1, 0}, {2, 0}})) << "without area";
  EXPECT_TRUE(is_convex({{0, 0}, {2, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 0}}));
  EXPECT_FALSE(is_convex({{0, 0}, {4, 0}, {2, 0}, {2, 3}})) << "a spike";
  EXPECT_FALSE(is_convex({}));
  EXPECT_FALSE(is_convex({{0, 0}, {1, 1}}));
}

// rows: PG-15
TEST(IsConvex, DecidesByOneUnit) {
  Ring ring{{0, 0}, {1.5, 0.5}, {3, 1}, {0, 3}};
  EXPECT_TRUE(is_convex(ring));
  ring[1].y = std::nextafter(0.5, 1.0);
  EXPECT_FALSE(is_convex(ring));
  ring[1].y = std::nextafter(0.5, 0.0);
  EXPECT_TRUE(is_convex(ring));
}

// rows: PG-15
TEST(IsConvex, MeansThatEveryVertexLiesOnOneSideOfEveryEdge) {
  std::mt19937_64 random(3);
  int convex = 0;
  for (int i = 0; i < 50000; ++i) {
    Ring ring(3 + random() % 3);
    for (Vec2d& p : ring) p = {static_cast<double>(random() % 5), static_cast<double>(random() % 5)};
    // By definition: no edge has vertices on both sides, and the way round turns once without folding back.
    int least = 1, most = -1;
    bool folded = false;
    for (std::size_t e = 0; e < ring.size(); ++e)
      for (const Vec2d p : ring) {
        const int side = orientation(ring[e], ring[next_index(e, ring.size())], p);
        least = std::min(least, side), most = std::max(most, side);
      }
    Ring distinct;
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (ring[k] != ring[previous_index(k, ring.size())]) distinct.push_back(ring[k]);
    for (std::size_t k = 0; k < distinct.size(); ++k) {
      const std::size_t n = distinct.size();
      folded = folded || turning_angle(distinct[previous_index(k, n)], distinct[k], distinct[next_index(k, n)]) > 3.14;
    }
    const bool expected = least * most >= 0 && least != most && !folded && std::abs(total_turning(ring)) < 7;
    ASSERT_EQ(is_convex(ring), expected);
    convex += expected;
  }
  EXPECT_GT(convex, 5000);
}

// rows: PG-20
TEST(ReflexVertices, GoByTheRingsOwnOrientation) {
  const Ring comb{{0, 0}, {10, 0}, {10, 5}, {7, 1}, {5, 5}, {3, 1}, {0, 5}};
  EXPECT_EQ(reflex_vertices(comb), (std::vector<std::size_t>{3, 5}));
  EXPECT_EQ(reflex_vertices(reversed(comb)), (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(ring_orientation(comb), 1);
  EXPECT_EQ(ring_orientation(reversed(comb)), -1);
  EXPECT_EQ(ring_orientation({{0, 0}, {1, 1}, {2, 2}}), 0);
  EXPECT_EQ(ring_orientation({{0, 0}, {0, 0}, {2, 1}, {2, 2}, {0, 0}}), 1);
  EXPECT_TRUE(reflex_vertices({{0, 0}, {2, 0}, {2, 2}}).empty());
}

// rows: PG-20 PG-14
TEST(SplitQuad, TilesEverySimpleQuad) {
  std::mt19937_64 random(4);
  int concave = 0;
  for (int i = 0; i < 100000; ++i) {
    std::array<Vec2d, 4> quad;
    for (Vec2d& p : quad) p = {static_cast<double>(random() % 9), static_cast<double>(random() % 9)};
    const Ring ring(quad.begin(), quad.end());
    const auto crosses = [&](int e, int f) {
      const Vec2d a = quad[static_cast<std::size_t>(e)], b = quad[static_cast<std::size_t>((e + 1) % 4)];
      const Vec2d c = quad[static_cast<std::size_t>(f)], d = quad[static_cast<std::size_t>((f + 1) % 4)];
      return orientation(a, b, c) * orientation(a, b, d) <= 0 && orientation(c, d, a) * orientation(c, d, b) <= 0;
    };
    if (crosses(0, 2) || crosses(1, 3) || signed_area(ring) == 0) continue;  // not simple, or without area
    const std::vector<std::size_t> reflex = reflex_vertices(ring);
    ASSERT_LE(reflex.size(), 1u);
    const QuadSplit split = split_quad(quad);
    if (!reflex.empty()) {
      ++concave;
      ASSERT_EQ(split.start, reflex[0]);
    }
    double sum = 0;
    for (const auto& t : split.triangles) {
      const double a = signed_area(Ring{quad[t[0]], quad[t[1]], quad[t[2]]});
      ASSERT_GT(a * ring_orientation(ring), 0);
      sum += a;
    }
    ASSERT_EQ(sum, signed_area(ring));
  }
  EXPECT_GT(concave, 1000);
}

}  // namespace
}  // namespace lambert::polygon
