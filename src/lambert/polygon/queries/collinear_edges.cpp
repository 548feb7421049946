#include "lambert/polygon/queries/collinear_edges.h"

#include "lambert/polygon/ring.h"

#include <algorithm>
#include <array>

namespace lambert::polygon {
namespace {

using Index = std::uint32_t;

/// Looks along one line, edge by edge as they begin. Each edge follows on at most two others, so if it overlaps one
/// that it does not follow on, such a one is among the three that reach farthest.
class Line {
 public:
  Line(const SweepSegments& ring, std::optional<EdgeOverlap>& found) : ring_(ring), found_(found) {}

  void add(Index s) {
    const Vec2d left = ring_.edges[s].left, right = ring_.edges[s].right;
    for (std::size_t i = 0; i < count_; ++i) {
      if (compare_xy(ring_.edges[farthest_[i]].right, left) <= 0) continue;
      const std::size_t n = ring_.edges.size(), t = farthest_[i];
      const bool successive = next_index(s, n) == t || next_index(t, n) == s;
      if (!found_ || (found_->successive && !successive)) found_ = {s, t, successive, left / ring_.scale};
    }
    if (count_ < farthest_.size()) {
      farthest_[count_++] = s;
      return;
    }
    const auto nearest = std::min_element(farthest_.begin(), farthest_.end(), [&](Index a, Index b) {
      return compare_xy(ring_.edges[a].right, ring_.edges[b].right) < 0;
    });
    if (compare_xy(ring_.edges[*nearest].right, right) < 0) *nearest = s;
  }

 private:
  const SweepSegments& ring_;
  std::optional<EdgeOverlap>& found_;
  std::array<Index, 3> farthest_{};
  std::size_t count_ = 0;
};

}  // namespace

std::optional<EdgeOverlap> find_overlap(const SweepSegments& ring) {
  const auto offset = [&](Index s, Index t) {
    return orientation(ring.edges[s].left, ring.edges[s].right, ring.edges[t].left);
  };
  std::optional<EdgeOverlap> found;
  std::vector<Index> parallel;
  for (auto next = ring.by_slope.begin(); next != ring.by_slope.end();) {
    const Index rank = ring.rank[*next];
    parallel.clear();
    for (; next != ring.by_slope.end() && ring.rank[*next] == rank; ++next) parallel.push_back(*next);
    if (parallel.size() == 1) continue;
    std::stable_sort(parallel.begin(), parallel.end(), [&](Index s, Index t) {
      if (const int side = offset(s, t)) return side > 0;
      return compare_xy(ring.edges[s].left, ring.edges[t].left) < 0;
    });
    std::optional<Line> line;
    for (std::size_t i = 0; i < parallel.size(); ++i) {
      if (i == 0 || offset(parallel[i - 1], parallel[i]) != 0) line.emplace(ring, found);
      line->add(parallel[i]);
    }
    if (found && !found->successive) return found;
  }
  return found;
}

}  // namespace lambert::polygon
