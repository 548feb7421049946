#include "lambert/polygon/scan/scan_fill.h"

#include "lambert/polygon/clip/clip_test_tools.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace lambert::polygon {
namespace {

/// The winding number about the centre of a pixel, moved by next to nothing towards +x and by still less towards +y.
int winding_beside(const Rings& rings, Vec2d p) {
  int winding = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      if (a.y <= p.y && p.y < b.y && orientation(a, b, p) <= 0) --winding;
      if (b.y <= p.y && p.y < a.y && orientation(b, a, p) <= 0) ++winding;
    }
  return winding;
}

/// How often each pixel of the window is filled; spans must be in order, apart from each other and within the window.
template <class Rule>
std::map<std::pair<int, int>, int> filled(const Rings& rings, const Rule& rule, const PixelWindow& window) {
  std::map<std::pair<int, int>, int> pixels;
  int last_y = std::numeric_limits<int>::min(), last_x = 0;
  for_each_span(rings, rule, window, [&](int y, int begin, int end) {
    EXPECT_LT(begin, end);
    EXPECT_TRUE(window.x_begin <= begin && end <= window.x_end && window.y_begin <= y && y < window.y_end);
    EXPECT_TRUE(y > last_y || (y == last_y && begin > last_x));
    last_y = y, last_x = end;
    for (int x = begin; x < end; ++x) ++pixels[{x, y}];
  });
  return pixels;
}

// rows: PG-33
TEST(ScanFill, SpansAreThePixelsWhoseCentresTheRuleEncloses) {
  Chance chance(41);
  for (int run = 0; run < 6000; ++run) {
    Rings rings;
    for (int i = chance.whole(1, 3); i > 0; --i) {
      Ring ring = chance.wild(chance.whole(0, 9), 24);
      // A grid of halves runs through the centres; thirds come close to them.
      for (Vec2d& p : ring) p = run % 3 ? 0.5 * p : p / 3.0;
      rings.push_back(ring);
    }
    const PixelWindow window{chance.whole(-1, 4), chance.whole(4, 13), chance.whole(-1, 4), chance.whole(4, 13)};
    const auto check = [&](const auto& rule, const auto& inside) {
      const auto pixels = filled(rings, rule, window);
      for (int y = window.y_begin; y < window.y_end; ++y)
        for (int x = window.x_begin; x < window.x_end; ++x)
          ASSERT_EQ(pixels.contains({x, y}), inside(winding_beside(rings, {x + 0.5, y + 0.5}))) << run;
    };
    check(FillRule::even_odd, [](int w) { return w % 2 != 0; });
    check(FillRule::non_zero, [](int w) { return w != 0; });
    check(positive_winding, [](int w) { return w > 0; });
    check(negative_winding, [](int w) { return w < 0; });
  }
}

// rows: PG-33
TEST(ScanFill, CentresOnEdgesGoToTheRightAndUp) {
  const Ring square{{0.5, 0.5}, {2.5, 0.5}, {2.5, 2.5}, {0.5, 2.5}};
  const auto pixels = filled({square}, FillRule::even_odd, {0, 4, 0, 4});
  EXPECT_EQ(pixels.size(), 4u);
  EXPECT_TRUE(pixels.contains({0, 0}) && pixels.contains({1, 1}));
  EXPECT_EQ(filled({reversed(square)}, FillRule::non_zero, {0, 4, 0, 4}), pixels);
}

// rows: PG-33
TEST(ScanFill, TilesCoverEachPixelOnce) {
  Chance chance(42);
  for (int run = 0; run < 500; ++run) {
    // Triangles of a grid whose inner vertices are shaken, with all vertices on tenths or halves, about a big square.
    constexpr int cells = 4;
    const double unit = run % 2 ? 0.1 : 0.5;
    std::vector<Vec2d> points;
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) {
        Vec2d p(5 * i, 5 * j);
        if (i > 0 && i < cells && j > 0 && j < cells) p += unit * chance.on_grid(run % 2 ? 20 : 4);
        points.push_back(p);
      }
    std::map<std::pair<int, int>, int> sum;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      for (const auto& [pixel, n] : filled({{points[a], points[b], points[c]}}, FillRule::non_zero, {-1, 21, -1, 21}))
        sum[pixel] += n;
    };
    for (std::size_t j = 0; j < cells; ++j)
      for (std::size_t i = 0; i < cells; ++i) {
        const std::size_t a = j * (cells + 1) + i, b = a + 1, c = b + cells + 1, d = a + cells + 1;
        if ((i + j) % 2)
          add(a, b, c), add(a, c, d);
        else
          add(a, b, d), add(b, c, d);
      }
    ASSERT_EQ(sum.size(), 400u) << run;
    for (const auto& [pixel, n] : sum) ASSERT_EQ(n, 1) << run;
  }
}

// rows: PG-33
TEST(ScanFill, HugeCoordinatesStayInTheWindowAndEnd) {
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  for (const double size : {1e9, 1e18, 1e150, 1e308}) {
    const Ring square{{-size, -size}, {size, -size}, {size, size}, {-size, size}};
    EXPECT_EQ(filled({square}, FillRule::even_odd, {0, 3, 0, 3}).size(), 9u);
    const Ring wedge{{-size, 0}, {size, 0}, {0, size}};
    EXPECT_EQ(filled({wedge}, FillRule::even_odd, {-2, 2, -2, 2}).size(), 8u);
  }
  const Ring far{{-1e308, 0.25}, {1e308, 0.75}, {-1e308, 0.75}};
  EXPECT_EQ(filled({far}, FillRule::even_odd, {-2, 2, -2, 2}).size(), 2u);
  EXPECT_TRUE(filled({{{0, 0}, {1e-320, 1e-320}, {0, 1e-320}}}, FillRule::even_odd, {-2, 2, -2, 2}).empty());
  EXPECT_TRUE(filled({{{0, 0}, {9, 0}, {0, 9}}}, FillRule::even_odd, {5, 5, 0, 3}).empty());
  int spans = 0;
  for_each_span({{{-1, most - 3.0}, {1, most - 3.0}, {1, most + 9.0}}, {{-9, least}, {9, least}, {9, least + 2.0}}},
                FillRule::even_odd, PixelWindow{least, most, least, most}, [&](int, int, int) { ++spans; });
  EXPECT_EQ(spans, 5);
}

// rows: PG-33
TEST(ScanFill, WindowOfRings) {
  EXPECT_EQ(pixel_window({}), PixelWindow{});
  EXPECT_EQ(pixel_window({{{0.5, 0.6}, {3.5, 2}}}), (PixelWindow{0, 3, 1, 2}));
  Chance chance(43);
  for (int run = 0; run < 500; ++run) {
    Ring ring = chance.wild(5, 16);
    for (Vec2d& p : ring) p = 0.5 * p;
    ASSERT_EQ(filled({ring}, FillRule::non_zero, pixel_window({ring})),
              filled({ring}, FillRule::non_zero, {-9, 19, -9, 19}));
  }
}

// rows: PG-33
TEST(ScanFill, AreaIsThatOfTheRing) {
  Chance chance(44);
  const Ring ring = chance.star(100, {500, 500}, 200, 499);
  double pixels = 0;
  for_each_span({ring}, FillRule::even_odd, {0, 1000, 0, 1000},
                [&](int, int begin, int end) { pixels += end - begin; });
  EXPECT_NEAR(pixels, signed_area(ring), 1e-3 * signed_area(ring));
}

}  // namespace
}  // namespace lambert::polygon
