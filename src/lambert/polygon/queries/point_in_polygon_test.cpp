#include "lambert/polygon/queries/point_in_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lambert::polygon {
namespace {

Ring grid_ring(std::mt19937_64& random, std::size_t size, std::uint64_t side) {
  Ring ring(size);
  for (Vec2d& p : ring) p = {static_cast<double>(random() % side), static_cast<double>(random() % side)};
  return ring;
}

/// The sum of the angles under which the edges are seen.
int winding_by_angles(const Ring& ring, Vec2d p) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d a = ring[i] - p, b = ring[next_index(i, ring.size())] - p;
    sum += std::atan2(a.x * b.y - a.y * b.x, dot(a, b));
  }
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

// rows: PG-44 PG-45
TEST(Locate, CountsWindingsAndKnowsTheBoundary) {
  std::mt19937_64 random(1);
  int on = 0, twice = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ring ring = grid_ring(random, random() % 9, 6);
    const Vec2d p(0.5 * static_cast<double>(random() % 11), 0.5 * static_cast<double>(random() % 11));
    bool on_edge = false;
    for (std::size_t k = 0; k < ring.size(); ++k)
      on_edge = on_edge || on_segment(ring[k], ring[next_index(k, ring.size())], p);
    const Winding w = winding_around(ring, p);
    ASSERT_EQ(w.on, on_edge);
    on += on_edge;
    if (on_edge) {
      ASSERT_EQ(locate(ring, p), Place::on);
      continue;
    }
    const int expected = winding_by_angles(ring, p);
    ASSERT_EQ(w.number, expected);
    twice += std::abs(expected) == 2;
    ASSERT_EQ(locate(ring, p, FillRule::non_zero), expected != 0 ? Place::inside : Place::outside);
    ASSERT_EQ(locate(ring, p, FillRule::even_odd), expected % 2 != 0 ? Place::inside : Place::outside);
    ASSERT_EQ(shimrat(ring, p), expected % 2 != 0);
    ASSERT_EQ(strips_around(ring, p) % 2 != 0, expected % 2 != 0);
  }
  EXPECT_GT(on, 1000);
  EXPECT_GT(twice, 10);
}

// rows: PG-45
TEST(Locate, TakesHolesAsRings) {
  const Rings frame{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}};
  for (const FillRule rule : {FillRule::even_odd, FillRule::non_zero}) {
    EXPECT_EQ(locate(frame, {1, 4}, rule), Place::inside);
    EXPECT_EQ(locate(frame, {4, 4}, rule), Place::outside);
    EXPECT_EQ(locate(frame, {3, 4}, rule), Place::on);
    EXPECT_EQ(locate(frame, {9, 9}, rule), Place::on);
  }
  EXPECT_EQ(locate(Rings{}, {0, 0}), Place::outside);
  EXPECT_EQ(locate(Rings{{}, {{1, 1}}}, {1, 1}), Place::on);
  EXPECT_EQ(locate(Ring{{1, 1}, {3, 3}}, {2, 2}), Place::on);
  EXPECT_EQ(locate(Ring{{1, 1}, {3, 3}}, {2, 2.5}), Place::outside);
}

// rows: PG-45 PG-47
TEST(Shimrat, GivesTheBoundaryToOneSideAndTheCullAgrees) {
  const Ring square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Box2 box = box_of(square);
  for (const auto& [p, inside] : {std::pair(Vec2d(0.5, 1), true), std::pair(Vec2d(0.5, 0), false),
                                  std::pair(Vec2d(1, 0.5), true), std::pair(Vec2d(0, 0.5), false)}) {
    EXPECT_EQ(shimrat(square, p), inside);
    EXPECT_EQ(shimrat_with_cull(square, box, p), inside);
  }
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const Ring ring = grid_ring(random, random() % 9, 5);
    const Vec2d p(0.5 * static_cast<double>(random() % 13) - 1, 0.5 * static_cast<double>(random() % 13) - 1);
    ASSERT_EQ(shimrat(ring, p), shimrat_with_cull(ring, box_of(ring), p));
  }
}

// rows: PG-45
TEST(Shimrat, PutsEachPointIntoOneTileExactly) {
  // A fan of triangles about a point tiles a square.
  std::mt19937_64 random(3);
  const Ring square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  for (int i = 0; i < 2000; ++i) {
    const Vec2d centre(1 + static_cast<double>(random() % 7), 1 + static_cast<double>(random() % 7));
    const Vec2d p(static_cast<double>(random() % 17) / 2, static_cast<double>(random() % 17) / 2);
    int tiles = 0;
    for (std::size_t k = 0; k < 4; ++k) tiles += shimrat({square[k], square[next_index(k, 4)], centre}, p);
    ASSERT_EQ(tiles, shimrat(square, p));
  }
}

// rows: PG-45
TEST(Locate, DecidesByOneUnit) {
  const Ring triangle{{0, 0}, {3, 1}, {0, 3}};
  EXPECT_EQ(locate(triangle, {1.5, 0.5}), Place::on);
  EXPECT_EQ(locate(triangle, {1.5, std::nextafter(0.5, 1.0)}), Place::inside);
  EXPECT_EQ(locate(triangle, {1.5, std::nextafter(0.5, 0.0)}), Place::outside);
}

}  // namespace
}  // namespace lambert::polygon
