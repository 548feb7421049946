#pragma once
/// Whether pieces tile what rings enclose.

#include "lambert/polygon/decompose/flat_rings.h"
#include "lambert/polygon/decompose/triangle.h"
#include "lambert/polygon/test_polygons.h"

#include <gtest/gtest.h>

#include <span>
#include <vector>

namespace lambert::polygon::test {

inline Ring corners_of(const Triangle& t, std::span<const Vec2d> vertices) {
  return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
}
inline std::vector<Ring> corners_of(std::span<const Triangle> triangles, std::span<const Vec2d> vertices) {
  std::vector<Ring> rings;
  for (const Triangle& t : triangles) rings.push_back(corners_of(t, vertices));
  return rings;
}

/// The sum of the areas, to more digits than double.
inline double total_area(const Rings& rings) {
  long double twice = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const Vec2d a = ring[i - 1] - ring[0], b = ring[i] - ring[0];
      twice += static_cast<long double>(a.x) * b.y - static_cast<long double>(a.y) * b.x;
    }
  return static_cast<double>(twice / 2);
}

/// No corner turns right, and some turns left. Exact.
inline bool is_convex_ccw(const Ring& ring) {
  bool turns = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t k = next_index(i, ring.size());
    const int turn = orientation(ring[i], ring[k], ring[next_index(k, ring.size())]);
    if (turn < 0) return false;
    turns = turns || turn > 0;
  }
  return turns;
}

/// Convex pieces with area, whose areas sum to that of the rings, of which every point inside lies in one and every
/// point outside in none (`samples` points of the box, decided exactly). `rings` are a region's: clockwise holes.
inline void expect_tiled(const Rings& rings, const std::vector<Ring>& pieces, Random& random, int samples = 50,
                         double tolerance = 1e-12) {
  for (const Ring& piece : pieces) ASSERT_TRUE(is_convex_ccw(piece));
  const double whole = total_area(rings);
  ASSERT_NEAR(total_area(pieces), whole, tolerance * std::abs(whole));
  if (rings.empty() || rings[0].empty()) return;
  Vec2d low = rings[0][0], high = low;
  for (const Vec2d p : rings[0]) low = glm::min(low, p), high = glm::max(high, p);
  for (int i = 0; i < samples; ++i) {
    const Vec2d p(between(random, low.x, high.x), between(random, low.y, high.y));
    const int place = locate(rings, p);
    if (place == 0) continue;
    int covering = 0;
    bool on_a_side = false;
    for (const Ring& piece : pieces) {
      const int in_piece = locate({piece}, p);
      covering += in_piece > 0;
      on_a_side = on_a_side || in_piece == 0;
    }
    if (on_a_side) continue;
    ASSERT_EQ(covering, place > 0 ? 1 : 0) << p.x << ' ' << p.y;
  }
}

/// Polygons of many kinds, all valid: `act(rings, holes)`.
template <class Act>
void for_each_valid_region(std::uint64_t seed, int rounds, const Act& act) {
  Random random(seed);
  for (int i = 0; i < rounds; ++i) {
    const std::size_t n = 3 + below(random, 40);
    act(Region{star(random, n), {}});
    act(Region{star(random, n, 1), {}});
    act(Region{comb(1 + n / 4), {}});
    act(Region{spiral(2 + n), {}});
    act(star_with_holes(random, n, 1 + below(random, 3), 3 + below(random, 6)));
    for (const std::size_t grid : {n / 3 + 2, n, std::size_t{1} << 20})
      if (const Ring ring = random_simple(random, n, grid); !ring.empty()) act(Region{ring, {}});
  }
}

}  // namespace lambert::polygon::test
