#pragma once
/// Polygons that tests and benchmarks share.

#include "lambert/polygon/predicates/predicates.h"
#include "lambert/polygon/ring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace lambert::polygon::test {

using Random = std::mt19937_64;

inline double between(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
inline std::size_t below(Random& random, std::size_t bound) { return random() % bound; }

/// Counter-clockwise around the origin, one corner in each of equal angles, radii between `inner` and 1.
inline Ring star(Random& random, std::size_t size, double inner = 0.1) {
  Ring ring;
  for (std::size_t i = 0; i < size; ++i) {
    const double phi = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size);
    ring.push_back(between(random, inner, 1) * Vec2d(std::cos(phi), std::sin(phi)));
  }
  return ring;
}

/// A bar with teeth upwards, all of one height: 2 teeth + 3 vertices.
inline Ring comb(std::size_t teeth) {
  Ring ring = {{0, -1}, {static_cast<double>(teeth), -1}};
  for (std::size_t i = teeth; i > 0; --i) {
    const auto x = static_cast<double>(i);
    ring.insert(ring.end(), {{x, 0}, {x - 0.5, 5}});
  }
  ring.push_back({0, 0});
  return ring;
}

/// A band of 2 size vertices that winds outwards.
inline Ring spiral(std::size_t size) {
  Ring ring;
  for (std::size_t i = 0; i < size; ++i) {
    const double phi = 0.1 * static_cast<double>(i);
    ring.push_back((2 + phi) * Vec2d(std::cos(phi), std::sin(phi)));
  }
  for (std::size_t i = size; i-- > 0;) {
    const double phi = 0.1 * static_cast<double>(i);
    ring.push_back((1 + phi) * Vec2d(std::cos(phi), std::sin(phi)));
  }
  return ring;
}

/// Segments that share more than an end they both name. Exact.
inline bool segments_meet(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const auto touches = [](Vec2d from, Vec2d to, Vec2d p) { return p != from && p != to && on_segment(from, to, p); };
  if (touches(a, b, c) || touches(a, b, d) || touches(c, d, a) || touches(c, d, b)) return true;
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// All pairs: no two edges meet but neighbours in their common vertex.
inline bool is_simple(const Rings& rings) {
  std::vector<std::pair<Vec2d, Vec2d>> edges;
  std::set<std::pair<double, double>> seen;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.emplace_back(ring[i], ring[next_index(i, ring.size())]);
      if (!seen.emplace(ring[i].x, ring[i].y).second) return false;
    }
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (segments_meet(edges[i].first, edges[i].second, edges[k].first, edges[k].second)) return false;
  return true;
}

/// Points on a grid joined in random order, then uncrossed by reversing the path between crossing edges, which shortens
/// it (2-opt): any simple polygon may come out, often with collinear runs. Counter-clockwise; empty when the points
/// are collinear or an edge runs through a vertex for good.
inline Ring random_simple(Random& random, std::size_t size, std::size_t grid) {
  std::set<std::pair<double, double>> places;
  for (std::size_t i = 0; i < 20 * size && places.size() < size; ++i)
    places.emplace(static_cast<double>(below(random, grid)), static_cast<double>(below(random, grid)));
  Ring ring;
  for (const auto& [x, y] : places) ring.push_back({x, y});
  std::shuffle(ring.begin(), ring.end(), random);
  const std::size_t n = ring.size();
  bool crossing = true;
  for (int round = 0; crossing && round < 500; ++round) {
    crossing = false;
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t k = i + 1; k < n; ++k) {
        if (!segments_meet(ring[i], ring[i + 1], ring[k], ring[next_index(k, n)])) continue;
        crossing = true;
        std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i + 1),
                     ring.begin() + static_cast<std::ptrdiff_t>(k + 1));
      }
  }
  if (n < 3 || !is_simple({ring}) || signed_area(ring) == 0) return {};
  if (signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// A star of 8 or more corners with radii above 0.6 and `per_side` x `per_side` small clockwise stars as holes around
/// the origin.
inline Region star_with_holes(Random& random, std::size_t size, std::size_t per_side, std::size_t hole_size) {
  Region region{star(random, std::max<std::size_t>(size, 8), 0.6), {}};
  const double cell = 0.7 / static_cast<double>(per_side);
  for (std::size_t row = 0; row < per_side; ++row)
    for (std::size_t column = 0; column < per_side; ++column) {
      Ring hole = star(random, hole_size);
      const Vec2d centre(-0.35 + cell * (static_cast<double>(column) + 0.5),
                         -0.35 + cell * (static_cast<double>(row) + 0.5));
      for (Vec2d& p : hole) p = centre + 0.45 * cell * p;
      std::reverse(hole.begin(), hole.end());
      region.holes.push_back(std::move(hole));
    }
  return region;
}

/// 1 inside, 0 on the boundary, -1 outside, by the even-odd rule. Exact.
inline int locate(const Rings& rings, Vec2d p) {
  bool inside = false;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      if (on_segment(a, b, p)) return 0;
      if ((a.y > p.y) != (b.y > p.y) && orientation(a, b, p) == (b.y > a.y ? 1 : -1)) inside = !inside;
    }
  return inside ? 1 : -1;
}

}  // namespace lambert::polygon::test
