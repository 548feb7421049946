#include "lambert/polygon/sweep/edge_hits.h"

#include "lambert/polygon/queries/segment.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace lambert::polygon {
namespace {

// rows: PG-49
TEST(EdgeHits, FindTheFirstOnTheWay) {
  const Rings square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  const auto first = first_edge_hit(square, {-2, 1}, {-1, 1});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->edge, 3u);
  EXPECT_EQ(first->t, 2);
  EXPECT_EQ(first->point, Vec2d(0, 1));
  EXPECT_EQ(first_edge_hit(square, {2, 1}, {3, 1})->edge, 1u) << "from inside";
  EXPECT_FALSE(first_edge_hit(square, {5, 1}, {6, 1})) << "behind";
  EXPECT_EQ(first_edge_hit(square, {5, 1}, {6, 1}, Reach::line)->edge, 3u);
  EXPECT_FALSE(first_edge_hit(square, {-2, 1}, {-1, 1}, Reach::segment)) << "too short";
  EXPECT_EQ(first_edge_hit(square, {-2, 1}, {0, 1}, Reach::segment)->t, 1);
  EXPECT_FALSE(first_edge_hit(square, {1, 1}, {1, 1}));
}

// rows: PG-49 PG-11
TEST(EdgeHits, MeetAVertexOnceAndAnEdgeAlongTheLine) {
  const Rings square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  const auto diagonal = edge_hits(square, {-1, -1}, {1, 1}, Reach::line);
  ASSERT_EQ(diagonal.size(), 2u);
  EXPECT_EQ(diagonal[0].edge, 0u);
  EXPECT_EQ(diagonal[1].edge, 2u);
  const auto along = edge_hits(square, {1, 4}, {3, 4}, Reach::segment);
  ASSERT_EQ(along.size(), 1u);
  EXPECT_EQ(along[0].edge, 2u);
  EXPECT_EQ(along[0].point, Vec2d(1, 4));
  EXPECT_EQ(along[0].to, Vec2d(3, 4));
}

Rings grid_rings(std::mt19937_64& random, std::size_t size, std::uint64_t side) {
  Rings rings(1 + random() % 3);
  for (Ring& ring : rings) {
    ring.resize(random() % size);
    for (Vec2d& p : ring) p = {static_cast<double>(random() % side), static_cast<double>(random() % side)};
  }
  return rings;
}

// rows: PG-49
TEST(EdgeHits, AreThoseOfSegmentIntersection) {
  std::mt19937_64 random(1);
  std::size_t met = 0;
  for (int i = 0; i < 20000; ++i) {
    const Rings rings = grid_rings(random, 9, 6);
    const auto coordinate = [&] { return static_cast<double>(random() % 13) / 2; };
    const Vec2d a(coordinate(), coordinate()), b(coordinate(), coordinate());
    if (a == b) continue;
    for (const Reach reach : {Reach::line, Reach::ray, Reach::segment}) {
      const Vec2d d = b - a, low = reach == Reach::line ? a - 16.0 * d : a,
                  high = reach == Reach::segment ? b : b + 16.0 * d;
      std::set<std::pair<std::size_t, std::size_t>> expected, found;
      for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::size_t e = 0; e < rings[r].size(); ++e) {
          const Segment edge{rings[r][e], rings[r][next_index(e, rings[r].size())]};
          const SegmentMeeting m = intersect(edge, {low, high});
          // An edge that is not along the line counts without its end.
          const bool at_end = m.kind == SegmentCase::crossing && m.from == edge.b;
          if (m.meet() && !at_end) expected.emplace(r, e);
        }
      const std::vector<EdgeHit> hits = edge_hits(rings, a, b, reach);
      for (std::size_t k = 0; k < hits.size(); ++k) {
        found.emplace(hits[k].ring, hits[k].edge);
        ASSERT_LT(length(a + hits[k].t * d - hits[k].point), 1e-12);
        ASSERT_LE(hits[k].t, hits[k].t_to);
        if (k > 0) {
          ASSERT_LE(hits[k - 1].t, hits[k].t + 1e-12);
        }
      }
      ASSERT_EQ(found, expected);
      ASSERT_EQ(found.size(), hits.size());
      met += hits.size();
      ASSERT_EQ(first_edge_hit(rings, a, b, reach), hits.empty() ? std::nullopt : std::optional(hits[0]));
    }
  }
  EXPECT_GT(met, 10000u);
}

// rows: PG-49
TEST(EdgeTree, AnswersLikeTheLoopOverAllEdges) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50; ++i) {
    const Rings rings = grid_rings(random, 200, 40);
    const EdgeTree tree(rings);
    for (int k = 0; k < 30; ++k) {
      const auto coordinate = [&] { return static_cast<double>(random() % 45) - 2; };
      const Vec2d a(coordinate(), coordinate()), b(coordinate(), coordinate());
      for (const Reach reach : {Reach::line, Reach::ray, Reach::segment}) {
        ASSERT_EQ(tree.edge_hits(a, b, reach), edge_hits(rings, a, b, reach));
        ASSERT_EQ(tree.first_edge_hit(a, b, reach), first_edge_hit(rings, a, b, reach));
      }
    }
  }
  EXPECT_TRUE(EdgeTree({}).edge_hits({0, 0}, {1, 1}, Reach::line).empty());
}

}  // namespace
}  // namespace lambert::polygon
