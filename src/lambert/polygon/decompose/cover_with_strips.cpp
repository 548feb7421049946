#include "lambert/polygon/decompose/strips.h"
#include "lambert/polygon/decompose/triangle_links.h"

#include <algorithm>
#include <utility>

namespace lambert::polygon {
namespace {

using Index = std::uint32_t;

class Coverer {
 public:
  explicit Coverer(std::span<const Triangle> triangles)
      : triangles_(triangles),
        opposite_(opposite_sides(triangles, vertex_count(triangles))),
        used_(triangles.size(), false),
        visited_(triangles.size(), 0) {}

  Strips run() {
    Strips all;
    for (Index t = 0; t < triangles_.size(); ++t) waiting_[free_neighbours(t)].push_back(t);
    for (std::size_t few = 0; few < 4;) {
      if (waiting_[few].empty()) {
        ++few;
        continue;
      }
      const Index t = waiting_[few].back();
      waiting_[few].pop_back();
      if (used_[t]) continue;
      all.strips.push_back(longest_from(t));
      few = 0;
    }
    return all;
  }

 private:
  static std::size_t vertex_count(std::span<const Triangle> triangles) {
    Index most = 0;
    for (const Triangle& t : triangles) most = std::max(most, *std::max_element(t.begin(), t.end()));
    return triangles.empty() ? 0 : std::size_t{most} + 1;
  }
  static Index after(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index before(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  std::size_t free_neighbours(Index t) const {
    std::size_t count = 0;
    for (Index s = 3 * t; s < 3 * t + 3; ++s)
      if (opposite_[s] != no_index && !used_[opposite_[s] / 3]) ++count;
    return count;
  }

  /// The triangles in turn when the strip's first three numbers are the corners from `first` on.
  std::vector<Index> way(Index first) {
    ++stamp_;
    std::vector<Index> sides = {first};
    visited_[first / 3] = stamp_;
    for (Index out = after(first);;) {
      const Index in = opposite_[out];
      if (in == no_index || used_[in / 3] || visited_[in / 3] == stamp_) return sides;
      visited_[in / 3] = stamp_;
      sides.push_back(in);
      // The two numbers last given are a side of the triangle: the one before `in` for reversed triangles.
      out = sides.size() % 2 == 0 ? before(in) : after(in);
    }
  }

  Indices longest_from(Index t) {
    std::vector<Index> best;
    for (Index s = 3 * t; s < 3 * t + 3; ++s)
      if (std::vector<Index> sides = way(s); sides.size() > best.size()) best = std::move(sides);
    const auto corner = [&](Index side) { return triangles_[side / 3][side % 3]; };
    Indices strip = {corner(best[0]), corner(after(best[0]))};
    for (const Index side : best) strip.push_back(corner(before(side)));
    for (const Index side : best) used_[side / 3] = true;
    for (const Index side : best)
      for (Index s = 3 * (side / 3), end = s + 3; s < end; ++s)
        if (const Index o = opposite_[s]; o != no_index && !used_[o / 3])
          waiting_[free_neighbours(o / 3)].push_back(o / 3);
    return strip;
  }

  std::span<const Triangle> triangles_;
  std::vector<Index> opposite_;
  std::vector<bool> used_;
  std::vector<Index> visited_;
  Index stamp_ = 0;
  std::array<std::vector<Index>, 4> waiting_;  // by number of free neighbours when they were put there
};

}  // namespace

Strips cover_with_strips(std::span<const Triangle> triangles) { return Coverer(triangles).run(); }

}  // namespace lambert::polygon
