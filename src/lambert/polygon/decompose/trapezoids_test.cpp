#include "lambert/polygon/decompose/trapezoids.h"

#include "lambert/polygon/decompose/convex_pieces.h"
#include "lambert/polygon/decompose/tiling_test_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace lambert::polygon {
namespace {

std::vector<Ring> rings_of_pieces(const Trapezoids& trapezoids) {
  std::vector<Ring> rings;
  for (const Trapezoid& t : trapezoids.pieces)
    rings.emplace_back(t.corners.begin(), t.corners.begin() + static_cast<std::ptrdiff_t>(t.size));
  return rings;
}

// rows: PG-22 PG-24 PG-25 PG-26 PG-27 PG-28 PG-29 PG-30 PG-31
TEST(Trapezoids, PiecesTileTheRegion) {
  test::Random random(1);
  test::for_each_valid_region(2, 40, [&](const Region& region) {
    const Trapezoids trapezoids = polygon::trapezoids(region);
    test::expect_tiled(rings_of(region), rings_of_pieces(trapezoids), random, 20);
    for (const Trapezoid& t : trapezoids.pieces) {
      ASSERT_TRUE(t.size == 3 || t.size == 4);
      // Two sides are level, or one and a corner.
      std::map<double, int> heights;
      for (std::size_t i = 0; i < t.size; ++i) ++heights[t.corners[i].y];
      ASSERT_EQ(heights.size(), 2u);
    }
  });
}

// rows: PG-23
TEST(Trapezoids, PiecesTileTheRegionAfterARandomRotation) {
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Region region = i % 2 ? test::star_with_holes(random, 3 + test::below(random, 30), 2, 5)
                                : Region{test::comb(1 + test::below(random, 10)), {}};
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Trapezoids a = trapezoids(region, {TieBreak::random_rotation, seed});
      // Turned back, a corner may be rounded to the wrong side of a piece's diagonal only where the piece is thin.
      std::vector<Ring> wide;
      for (const Ring& ring : rings_of_pieces(a))
        if (test::is_convex_ccw(ring)) wide.push_back(ring);
      ASSERT_LE(a.pieces.size() - wide.size(), a.pieces.size() / 20);
      test::expect_tiled(rings_of(region), wide, random, 20, 1e-11);
      const Trapezoids again = trapezoids(region, {TieBreak::random_rotation, seed});
      ASSERT_EQ(rings_of_pieces(a), rings_of_pieces(again));
    }
  }
}

// Corners on the two sides of a level line, and of an edge, are the same numbers.
TEST(Trapezoids, PiecesShareTheirCorners) {
  test::for_each_valid_region(4, 30, [&](const Region& region) {
    const auto pieces = rings_of_pieces(trapezoids(region));
    std::map<std::pair<double, double>, int> from_below, from_above;
    for (const Ring& ring : pieces) {
      const auto [low, high] =
          std::minmax_element(ring.begin(), ring.end(), [](Vec2d a, Vec2d b) { return a.y < b.y; });
      for (const Vec2d p : ring) ++(p.y == low->y ? from_above : from_below)[{p.x, p.y}], (void)high;
    }
    std::map<std::pair<double, double>, bool> vertices;
    for (const Ring& ring : rings_of(region))
      for (const Vec2d p : ring) vertices[{p.x, p.y}] = true;
    // A point that is no vertex lies on an edge that goes on.
    for (const auto& [p, count] : from_below) ASSERT_TRUE(vertices.count(p) || from_above.count(p));
    for (const auto& [p, count] : from_above) ASSERT_TRUE(vertices.count(p) || from_below.count(p));
  });
}

/// The case by its definition: sides of the neighbours, and whether the interior is between or right of the edges.
SweepCase by_definition(const Ring& ring, std::size_t i) {
  const auto above = [](Vec2d p, Vec2d q) { return compare_xy({p.y, p.x}, {q.y, q.x}) < 0; };
  const Vec2d before = ring[previous_index(i, ring.size())], v = ring[i], after = ring[next_index(i, ring.size())];
  const bool convex = orientation(before, v, after) > 0;
  if (above(v, before) && above(v, after)) return convex ? SweepCase::interior_minimum : SweepCase::exterior_minimum;
  if (above(before, v) && above(after, v)) return convex ? SweepCase::interior_maximum : SweepCase::exterior_maximum;
  // The interior is left of the ring: right of it in the plane when it runs down.
  return above(v, before) ? SweepCase::left_edge : SweepCase::right_edge;
}

TEST(Trapezoids, CasesAreThoseOfTheNotes) {
  test::for_each_valid_region(5, 30, [&](const Region& region) {
    const auto cases = trapezoids(region).cases;
    std::size_t k = 0;
    for (const Ring& ring : rings_of(region))
      for (std::size_t i = 0; i < ring.size(); ++i, ++k) ASSERT_EQ(cases[k], by_definition(ring, i)) << i;
    ASSERT_EQ(k, cases.size());
  });
}

// rows: PG-32
TEST(Trapezoids, TheExampleShowsAllSixCases) {
  const Region region{{{0, 0.0}, {5, 1.0}, {10, 0.1}, {11, 7.0}, {8, 9.0}, {7, 5.0}, {4, 5.5}, {2, 8.0}}, {}};
  const Trapezoids t = trapezoids(region);
  for (int c = 1; c <= 6; ++c) {
    const bool at_vertex = std::count(t.cases.begin(), t.cases.end(), static_cast<SweepCase>(c)) > 0;
    // The left side is one long edge, which meets the line between vertices only.
    EXPECT_EQ(at_vertex, c != 1) << c;
  }
  EXPECT_EQ(t.pieces.size(), 11u);
}

TEST(Trapezoids, RingsMayTouch) {
  test::Random random(6);
  const Region hole_on_edge{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{{0, 4}, {2, 6}, {2, 2}}}};
  const Region hole_in_corner{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{{0, 0}, {1, 4}, {4, 1}}}};
  const Region pinched{{{0, 0}, {4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}}, {}};
  const Region doubled{{{0, 0}, {8, 0}, {8, 0}, {8, 8}, {8, 12}, {8, 8}, {0, 8}, {0, 8}}, {}};
  for (const Region& region : {hole_on_edge, hole_in_corner, pinched, doubled})
    test::expect_tiled(rings_of(region), rings_of_pieces(trapezoids(region)), random, 200);
}

TEST(Trapezoids, TenThousandVerticesAreTiled) {
  test::Random random(7);
  for (const Ring& ring : {test::star(random, 10000, 0.8), test::comb(5000), test::star(random, 10000, 1)}) {
    long double area = 0;
    std::size_t pieces = 0;
    trapezoids(flat(Region{ring, {}}), [&](const Trapezoid& t) {
      ++pieces;
      area += static_cast<long double>(
          signed_area(Ring(t.corners.begin(), t.corners.begin() + static_cast<std::ptrdiff_t>(t.size))));
    });
    EXPECT_NEAR(static_cast<double>(area), test::total_area({ring}), 1e-12 * test::total_area({ring}));
    EXPECT_GT(pieces, 5000u);
  }
}

TEST(Trapezoids, AnythingEnds) {
  test::Random random(8);
  for (int i = 0; i < 20000; ++i) {
    Rings rings(1 + test::below(random, 3));
    const std::size_t grid = 1 + test::below(random, 6);
    for (Ring& ring : rings)
      for (std::size_t k = test::below(random, 12); k > 0; --k)
        ring.push_back(1e150 * Vec2d(static_cast<double>(test::below(random, grid)),
                                     static_cast<double>(test::below(random, grid))));
    const FlatRings all = flat(rings);
    for (const TieBreak tie_break : {TieBreak::symbolic, TieBreak::random_rotation}) {
      const auto cases =
          trapezoids(all, [](const Trapezoid& t) { ASSERT_TRUE(t.size == 3 || t.size == 4); }, {tie_break, 1});
      ASSERT_EQ(cases.size(), all.vertices.size());
    }
  }
}

// rows: PG-21
TEST(ConvexPieces, TileTheRegionInFewPieces) {
  test::Random random(9);
  test::for_each_valid_region(10, 40, [&](const Region& region) {
    std::size_t reflex = 0;
    for (const Ring& ring : rings_of(region))
      for (std::size_t i = 0; i < ring.size(); ++i)
        reflex += orientation(ring[previous_index(i, ring.size())], ring[i], ring[next_index(i, ring.size())]) < 0;
    const auto joined = convex_pieces(region);
    test::expect_tiled(rings_of(region), joined, random, 20);
    ASSERT_LE(joined.size(), 2 * reflex + 1);
    // No piece has more than one end in each reflex corner: at least half as many as these, and one, are needed.
    ASSERT_TRUE(!region.holes.empty() || joined.size() <= 4 * ((reflex + 1) / 2 + 1));
    test::expect_tiled(rings_of(region), convex_pieces(region, ConvexMethod::trapezoids), random, 5);
  });
}

TEST(ConvexPieces, WhatIsConvexIsOnePiece) {
  test::Random random(11);
  for (std::size_t n = 3; n < 50; ++n) {
    const auto pieces = convex_pieces({test::star(random, n, 1), {}});
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].size(), n);
  }
  // Corners of 180 degrees stay.
  EXPECT_EQ(convex_pieces({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}, {}})[0].size(), 6u);
  EXPECT_EQ(convex_pieces({test::comb(5), {}}).size(), 6u);
  EXPECT_TRUE(convex_pieces({}).empty());
}

}  // namespace
}  // namespace lambert::polygon
