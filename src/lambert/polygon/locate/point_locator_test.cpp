#include "lambert/polygon/locate/point_locator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace lambert::polygon {
namespace {

void expect_same(const Rings& rings, const PointLocator& locator, Vec2d p) {
  const Winding plain = winding_around(rings, p), fast = locator.winding(p);
  ASSERT_EQ(fast.on, plain.on) << p.x << ' ' << p.y;
  if (!plain.on) {
    ASSERT_EQ(fast.number, plain.number) << p.x << ' ' << p.y;
  }
  for (const FillRule rule : {FillRule::even_odd, FillRule::non_zero})
    ASSERT_EQ(locator.locate(p, rule), locate(rings, p, rule));
}

// rows: PG-45 PG-47
TEST(PointLocator, AnswersLikeThePlainTestOnGrids) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t side = 1 + random() % 8;
    Rings rings(random() % 4);
    for (Ring& ring : rings) {
      ring.resize(random() % 12);
      for (Vec2d& p : ring) p = {static_cast<double>(random() % side), static_cast<double>(random() % side)};
    }
    const PointLocator locator(rings);
    for (int k = 0; k < 20; ++k) {
      const Vec2d p(0.25 * static_cast<double>(random() % (4 * side + 2)) - 0.25,
                    0.25 * static_cast<double>(random() % (4 * side + 2)) - 0.25);
      expect_same(rings, locator, p);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

// rows: PG-45
TEST(PointLocator, AnswersLikeThePlainTestOnLargeRings) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const std::size_t n = 2000;
  Ring star, tangle, circle, comb;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / n, r = 0.7 + 0.3 * coordinate(random);
    const Vec2d direction(std::cos(angle), std::sin(angle));
    star.push_back(r * direction), circle.push_back(direction);
    tangle.emplace_back(coordinate(random), coordinate(random));
    comb.emplace_back(static_cast<double>(i / 2 + i % 2), i % 4 < 2 ? 0 : 10);
  }
  comb.emplace_back(static_cast<double>(n / 2), -5);
  comb.emplace_back(0, -5);
  for (const Ring& ring : {star, tangle, circle, comb}) {
    const Rings rings{ring};
    const PointLocator locator(rings);
    const Vec2d low = locator.box().min, size = locator.box().size();
    const auto anywhere = [&] { return low + size * (0.5 + 0.55 * Vec2d(coordinate(random), coordinate(random))); };
    for (int k = 0; k < 1500; ++k) {
      expect_same(rings, locator, anywhere());
      const std::size_t i = random() % ring.size();
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      expect_same(rings, locator, a);
      expect_same(rings, locator, 0.5 * (a + b));
      expect_same(rings, locator, {a.x, anywhere().y});
      expect_same(rings, locator, {std::nextafter(a.x, 2.0), a.y});
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

// rows: PG-45
TEST(PointLocator, ServesFlatAndFarAndTinyRings) {
  const double unit = 0x1p-52;
  const Rings cases{{{1, 1}, {1, 5}, {1, 3}},
                    {{1, 1}, {1 + unit, 1}, {1 + unit, 1 + unit}, {1, 1 + unit}},
                    {{1e15, 1e15}, {1e15 + 1, 1e15}, {1e15, 1e15 + 1}},
                    {{1e-150, 0}, {2e-150, 0}, {1e-150, 1e-150}},
                    {{-1e150, 0}, {1e150, 0}, {0, 1e150}},
                    {{2, 2}},
                    {}};
  std::mt19937_64 random(3);
  for (const Ring& ring : cases) {
    const Rings rings{ring};
    const PointLocator locator(rings);
    for (const Vec2d a : ring)
      for (const Vec2d b : ring)
        for (const Vec2d p : {a, b, 0.5 * (a + b), Vec2d(a.x, b.y), Vec2d(std::nextafter(a.x, b.x), b.y)})
          expect_same(rings, locator, p);
  }
  // Many edges in a box of few units.
  Ring crowded;
  for (int i = 0; i < 500; ++i)
    crowded.emplace_back(1 + static_cast<double>(random() % 9) * unit, 1 + static_cast<double>(random() % 9) * unit);
  const PointLocator locator(Rings{crowded});
  for (int i = 0; i < 100; ++i)
    expect_same({crowded}, locator, {1 + static_cast<double>(i / 10) * unit, 1 + static_cast<double>(i % 10) * unit});
}

}  // namespace
}  // namespace lambert::polygon
