#include "lambert/polygon/scan_table.h"

#include "lambert/polygon/clip_test_tools.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include <set>

namespace lambert::polygon {

void PrintTo(const PixelSpan& span, std::ostream* out) { *out << span.y << ": " << span.first << ".." << span.last; }

namespace {

using Table = std::vector<PixelSpan>;

// rows: PG-33
TEST(ScanTable, StepsRoundToTheNearestWholeNumber) {
  Chance chance(51);
  for (int run = 0; run < 3000; ++run) {
    const Vec2i low(chance.whole(-50, 50), chance.whole(-50, 0)), high(chance.whole(-50, 50), chance.whole(1, 50));
    EdgeDda dda(low, high);
    for (int y = low.y; y <= high.y; ++y, dda.step()) {
      const int up = y - low.y, height = high.y - low.y;
      // |x - crossing| <= 1/2, and never half below it.
      const int twice = 2 * ((dda.x() - low.x) * height - (high.x - low.x) * up);
      ASSERT_TRUE(-height < twice && twice <= height);
    }
  }
}

// rows: PG-33
TEST(ScanTable, CornersAndHorizontalEdgesAreFilledWhole) {
  EXPECT_EQ(scan_table(Rings{{{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 4}, {0, 4}}}),
            (Table{{0, 0, 6}, {1, 0, 6}, {2, 0, 6}, {3, 0, 3}, {4, 0, 3}}));
  // Tips of a crown and the bottoms of its notches.
  EXPECT_EQ(scan_table(Rings{{{0, 0}, {8, 0}, {8, 4}, {6, 2}, {4, 4}, {2, 2}, {0, 4}}}),
            (Table{{0, 0, 8}, {1, 0, 8}, {2, 0, 8}, {3, 0, 1}, {3, 3, 5}, {3, 7, 8}, {4, 0, 0}, {4, 4, 4}, {4, 8, 8}}));
  EXPECT_EQ(scan_table(Rings{{{2, 1}, {5, 1}}}), (Table{{1, 2, 5}}));
  EXPECT_TRUE(scan_table(Rings{}).empty());
  EXPECT_TRUE(scan_table(Rings{{}}).empty());
  EXPECT_EQ(scan_table(Rings{{{2.4, 0.6}}}), (Table{{1, 2, 2}}));
}

// rows: PG-33
TEST(ScanTable, HolesAndFillRules) {
  const Ring outer{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, hole{{3, 3}, {6, 3}, {6, 6}, {3, 6}};
  const auto pixels = [](const Table& table) {
    int sum = 0;
    for (const PixelSpan& span : table) sum += span.last - span.first + 1;
    return sum;
  };
  EXPECT_EQ(pixels(scan_table(Rings{outer})), 100);
  EXPECT_EQ(pixels(scan_table(Rings{outer, hole})), 100 - 4);  // its inclusive edges are filled
  EXPECT_EQ(pixels(scan_table(Rings{outer, hole}, FillRule::non_zero)), 100);
}

/// Every pixel whose centre (here a whole point) the ring encloses is filled, but for those that rounding puts within
/// half a pixel of an edge; no pixel is filled that is farther than that from the ring and outside it.
// rows: PG-33
TEST(ScanTable, HoldsTheInteriorAndLittleMore) {
  Chance chance(52);
  for (int run = 0; run < 1000; ++run) {
    const Ring ring = chance.wild(chance.whole(3, 9), 20);
    const Table table = scan_table(Rings{ring});
    std::set<std::pair<int, int>> pixels;
    for (const PixelSpan& span : table)
      for (int x = span.first; x <= span.last; ++x) pixels.insert({x, span.y});
    EXPECT_EQ(scan_table(Rings{reversed(ring)}), table);
    EXPECT_EQ(scan_table(Rings{rotated(ring, 2)}), table);
    for (int y = -1; y <= 21; ++y)
      for (int x = -1; x <= 21; ++x) {
        const auto winding = winding_number({ring}, {x, y});
        bool near_edge = !winding;
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
          if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y || a.y == b.y) continue;
          near_edge = near_edge || std::abs(a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y) - x) <= 0.5;
        }
        if (near_edge) continue;
        ASSERT_EQ(pixels.contains({x, y}), *winding % 2 != 0) << run << ": " << x << " " << y;
      }
  }
}

// rows: PG-33
TEST(ScanTable, CoordinatesBeyondItsReachAreRefused) {
  constexpr int reach = scan_table_reach;
  const Table table = scan_table(Rings{{{reach, 0}, {reach, 1}, {-reach, 1}, {-reach, 0}}});
  EXPECT_EQ(table, (Table{{0, -reach, reach}, {1, -reach, reach}}));
  EXPECT_THROW(scan_table(Rings{{{1e300, 0}, {1e300, 2}, {0, 0}}}), std::out_of_range);
  EXPECT_THROW(scan_table(std::vector<std::vector<Vec2i>>{{{0, 0}, {1, 0}, {0, -reach - 1}}}), std::out_of_range);
}

}  // namespace
}  // namespace lambert::polygon
