// Grids, repeated points and sizes from the smallest to the largest double: the fast queries must agree with the plain
// ones, and all must end.

#include "lambert/polygon/convex.h"
#include "lambert/polygon/edge_hits.h"
#include "lambert/polygon/intersections.h"
#include "lambert/polygon/pick.h"
#include "lambert/polygon/point_locator.h"
#include "lambert/polygon/simple.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lambert::polygon {
namespace {

enum class Size { small_integers, huge, tiny, mixed, units_in_the_last_place, any };

class Degenerate : public testing::TestWithParam<Size> {
 protected:
  double coordinate() {
    const double integer = static_cast<double>(random_() % side_) - static_cast<double>(side_ / 2);
    switch (GetParam()) {
      case Size::small_integers: return integer;
      case Size::huge: return 1e150 * integer;
      case Size::tiny: return 1e-150 * integer;
      case Size::mixed: return std::ldexp(integer, static_cast<int>(random_() % 40) - 20);
      case Size::units_in_the_last_place: return 1 + 0x1p-52 * integer;
      case Size::any: return std::ldexp(integer, static_cast<int>(random_() % 2040) - 1020);
    }
    return 0;
  }
  Vec2d point() {
    const double x = coordinate();
    return {x, coordinate()};
  }
  Rings rings() {
    side_ = 1 + random_() % 12;
    Rings rings(1 + random_() % 3);
    for (Ring& ring : rings)
      for (std::size_t n = random_() % 20; ring.size() < n;)
        ring.push_back(!ring.empty() && random_() % 5 == 0 ? ring.back() : point());
    return rings;
  }

  std::mt19937_64 random_{1};
  std::uint64_t side_ = 1;
};

INSTANTIATE_TEST_SUITE_P(Sizes, Degenerate,
                         testing::Values(Size::small_integers, Size::huge, Size::tiny, Size::mixed,
                                         Size::units_in_the_last_place, Size::any));

// rows: PG-06 PG-07
TEST_P(Degenerate, SweepsAgreeWithPairs) {
  for (int i = 0; i < (GetParam() == Size::any ? 200 : 2000); ++i) {
    const Ring ring = rings()[0];
    std::vector<Segment> edges;
    for (std::size_t k = 0; k < ring.size(); ++k) edges.push_back({ring[k], ring[next_index(k, ring.size())]});
    const auto swept = all_intersections(edges), tried = all_intersections_by_pairs(edges);
    const auto kind = check_simple(ring).kind, kind_by_pairs = check_simple_by_pairs(ring).kind;
    is_convex(ring), total_turning(ring), reflex_vertices(ring);
    ASSERT_EQ(kind, kind_by_pairs);
    ASSERT_TRUE(std::equal(swept.begin(), swept.end(), tried.begin(), tried.end(), [](const auto& a, const auto& b) {
      return a.first == b.first && a.second == b.second && a.meeting.kind == b.meeting.kind;
    }));
  }
}

// rows: PG-45 PG-49
TEST_P(Degenerate, IndicesAgreeWithLoops) {
  for (int i = 0; i < (GetParam() == Size::any ? 20 : 1000); ++i) {
    const Rings polygon = rings();
    const PointLocator locator(polygon);
    const EdgeTree tree(polygon);
    for (int k = 0; k < 8; ++k) {
      const Vec2d p = point(), q = k % 2 && !polygon[0].empty() ? polygon[0][0] : point();
      const Winding plain = winding_around(polygon, p), fast = locator.winding(p);
      for (const Reach reach : {Reach::line, Reach::ray, Reach::segment}) {
        const auto by_loop = edge_hits(polygon, p, q, reach), by_tree = tree.edge_hits(p, q, reach);
        const auto first = first_edge_hit(polygon, p, q, reach);
        const auto edges = [](const std::vector<EdgeHit>& hits) {
          std::vector<std::pair<std::size_t, std::size_t>> numbers;
          for (const EdgeHit& hit : hits) numbers.emplace_back(hit.ring, hit.edge);
          return numbers;
        };
        ASSERT_EQ(edges(by_loop), edges(by_tree));
        ASSERT_EQ(first.has_value(), !by_loop.empty());
        if (first) {
          ASSERT_EQ(edges({*first}), edges({by_loop[0]}));
        }
        // Points may be rounded by different scales.
        if (GetParam() == Size::any) continue;
        ASSERT_EQ(by_loop, by_tree);
        ASSERT_EQ(first, by_loop.empty() ? std::nullopt : std::optional(by_loop[0]));
      }
      ASSERT_EQ(fast.on, plain.on);
      if (!plain.on) {
        ASSERT_EQ(fast.number, plain.number);
      }
    }
  }
}

}  // namespace
}  // namespace lambert::polygon
