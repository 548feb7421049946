#include "lambert/polygon/intersections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lambert::polygon {
namespace {

using Segments = std::vector<Segment>;

std::string text(const Segments& segments) {
  std::string s;
  for (const Segment& v : segments)
    s += "(" + std::to_string(v.a.x) + " " + std::to_string(v.a.y) + " - " + std::to_string(v.b.x) + " " +
         std::to_string(v.b.y) + ") ";
  return s;
}

/// Returns how many pairs meet.
std::size_t expect_same_as_by_pairs(const Segments& segments, double scale = 1) {
  const auto found = all_intersections(segments), expected = all_intersections_by_pairs(segments);
  EXPECT_EQ(found.size(), expected.size()) << (segments.size() < 20 ? text(segments) : "");
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
    const SegmentPair &a = found[i], &b = expected[i];
    const bool same = a.first == b.first && a.second == b.second && a.meeting.kind == b.meeting.kind &&
                      length((a.meeting.from - b.meeting.from) / scale) < 1e-12 &&
                      length((a.meeting.to - b.meeting.to) / scale) < 1e-12;
    EXPECT_TRUE(same) << a.first << "-" << a.second << " against " << b.first << "-" << b.second
                      << (segments.size() < 20 ? text(segments) : "");
    if (!same) break;
  }
  return expected.size();
}

// rows: PG-06 PG-07 PG-10 PG-12
TEST(AllIntersections, AgreeWithPairsOnSmallGrids) {
  std::mt19937_64 random(1);
  std::size_t met = 0;
  for (int i = 0; i < 30000; ++i) {
    const std::uint64_t side = 2 + random() % 5;
    Segments segments(2 + random() % 12);
    for (Segment& s : segments)
      for (Vec2d* p : {&s.a, &s.b}) *p = {static_cast<double>(random() % side), static_cast<double>(random() % side)};
    met += expect_same_as_by_pairs(segments);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(met, 100000u);
}

// rows: PG-07
TEST(AllIntersections, AgreeWithPairsOnLargerGrids) {
  std::mt19937_64 random(2);
  for (const std::uint64_t side : {8u, 30u, 1000u}) {
    Segments segments(400);
    for (Segment& s : segments)
      for (Vec2d* p : {&s.a, &s.b}) *p = {static_cast<double>(random() % side), static_cast<double>(random() % side)};
    EXPECT_GT(expect_same_as_by_pairs(segments), 1000u);
  }
}

// rows: PG-07
TEST(AllIntersections, SortCrossingsThatDoublesCannotTellApart) {
  // Segments through nearly one point, whose crossings differ by less than a unit in the last place.
  std::mt19937_64 random(3);
  const auto nudge = [&](double c) { return c + static_cast<double>(random() % 5) * 0x1p-50; };
  for (int i = 0; i < 300; ++i) {
    Segments segments;
    for (int k = 0; k < 12; ++k) {
      const Vec2d d(static_cast<double>(random() % 9) - 4, static_cast<double>(random() % 9) - 4);
      segments.push_back({{nudge(5 - d.x), nudge(5 - d.y)}, {nudge(5 + d.x), nudge(5 + d.y)}});
    }
    expect_same_as_by_pairs(segments);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(AllIntersections, ServeCoordinatesOfAnySize) {
  std::mt19937_64 random(4);
  for (const double scale : {1e-300, 1e-150, 1e150, 1e300})
    for (int i = 0; i < 300; ++i) {
      Segments segments(10);
      for (Segment& s : segments)
        for (Vec2d* p : {&s.a, &s.b})
          *p = scale * Vec2d(static_cast<double>(random() % 9), static_cast<double>(random() % 9));
      expect_same_as_by_pairs(segments, scale);
      if (testing::Test::HasFailure()) return;
    }
}

TEST(AllIntersections, EndWhateverTheRangeOfSizes) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i) {
    Segments segments(20);
    for (Segment& s : segments)
      for (Vec2d* p : {&s.a, &s.b})
        for (int axis = 0; axis < 2; ++axis)
          (*p)[axis] = std::ldexp(static_cast<double>(random() % 3) - 1, static_cast<int>(random() % 2000) - 1000);
    EXPECT_LE(all_intersections(segments).size(), segments.size() * (segments.size() - 1) / 2);
  }
}

TEST(AllIntersections, OfNothingAreNone) {
  EXPECT_TRUE(all_intersections(Segments{}).empty());
  EXPECT_TRUE(all_intersections(Segments{{{1, 1}, {1, 1}}}).empty());
  EXPECT_EQ(all_intersections(Segments{{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}).size(), 1u);
}

}  // namespace
}  // namespace lambert::polygon
