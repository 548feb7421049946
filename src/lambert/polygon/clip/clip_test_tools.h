#pragma once
/// What the tests of clipping and filling share: exact winding numbers as an oracle, rings by chance.

#include "lambert/polygon/predicates/predicates.h"
#include "lambert/polygon/ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

namespace lambert::polygon {

/// How often the rings wind around p, by brute force; nothing when p lies on an edge.
inline std::optional<int> winding_number(const Rings& rings, Vec2d p) {
  int winding = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
      if (on_segment(a, b, p)) return std::nullopt;
      if (a.y <= p.y && b.y > p.y && orientation(a, b, p) > 0) ++winding;
      if (b.y <= p.y && a.y > p.y && orientation(a, b, p) < 0) --winding;
    }
  return winding;
}

struct Chance {
  std::mt19937_64 generator;
  explicit Chance(std::uint64_t seed) : generator(seed) {}

  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(generator); }
  double real(double from, double to) { return std::uniform_real_distribution<double>(from, to)(generator); }
  Vec2d on_grid(int size) { return {whole(0, size), whole(0, size)}; }
  Vec2d in_square(double size) { return {real(0, size), real(0, size)}; }

  /// Anything: crossings, repeated points, collinear runs, spikes.
  Ring wild(int vertices, int grid) {
    Ring ring;
    for (int i = 0; i < vertices; ++i) ring.push_back(on_grid(grid));
    return ring;
  }
  /// Simple, counter-clockwise, star-shaped about `centre`; at least 4 vertices.
  Ring star(int vertices, Vec2d centre, double least_radius, double radius) {
    std::vector<double> angles;
    for (int i = 0; i < vertices; ++i) angles.push_back((i + real(0, 0.9)) / vertices * 2 * std::numbers::pi);
    Ring ring;
    for (const double angle : angles)
      ring.push_back(centre + real(least_radius, radius) * Vec2d(std::cos(angle), std::sin(angle)));
    return ring;
  }
  /// Simple, counter-clockwise, with corners on a grid that lines run through: an upper and a lower staircase of
  /// spikes.
  Ring comb(int columns, int height) {
    Ring ring;
    for (int x = 0; x <= columns; ++x) ring.push_back({x, whole(-height, -1)});
    for (int x = columns; x >= 0; --x) ring.push_back({x, whole(0, height)});
    return ring;
  }
};

inline Ring rotated(Ring ring, std::size_t by) {
  if (!ring.empty())
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(by % ring.size()), ring.end());
  return ring;
}
inline Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

inline bool comes_before(const Ring& a, const Ring& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](Vec2d p, Vec2d q) { return compare_xy(p, q) < 0; });
}

/// The same for rings that differ only in their first vertex and their order.
inline Rings canonical(Rings rings) {
  for (Ring& ring : rings) {
    Ring least = ring;
    for (std::size_t i = 1; i < ring.size(); ++i)
      if (const Ring turned = rotated(ring, i); comes_before(turned, least)) least = turned;
    ring = least;
  }
  std::sort(rings.begin(), rings.end(), comes_before);
  return rings;
}

}  // namespace lambert::polygon
