#pragma once
/// The plane sweep under the intersection queries: from left to right over segments, with every decision exact.
///
/// It follows Bentley and Ottmann (1979) but for the order of events: only the ends of segments are sorted. A crossing
/// is kept with the first end that comes after it, and all crossings between two ends are worked off in any order, each
/// by exchanging two neighbours; when none is left the order is that at the next end (Boissonnat and Preparata, "Robust
/// plane sweep for intersecting segments", 2000). So no two crossings are ever compared, and the hardest question is
/// compare_crossing(), of degree three. Ends of equal x are taken from below (as if the plane were sheared a little),
/// so vertical segments need no case of their own.

#include "lambert/polygon/queries/segment.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambert::polygon {

/// Segments as the sweep wants them: from the lexicographically lower end to the higher one, brought to a safe scale
/// and ranked by slope.
struct SweepSegments {
  struct Edge {
    Vec2d left, right;
  };
  std::vector<Edge> edges;
  /// Equal for parallel segments, increasing with slope, vertical last. Of points: 0, without meaning.
  std::vector<std::uint32_t> rank;
  std::vector<std::uint32_t> by_slope;  ///< all that are no points, by ascending rank
  double scale = 1;                     ///< what the coordinates were multiplied by, a power of two

  bool is_point(std::uint32_t s) const { return edges[s].left == edges[s].right; }
};

/// O(n log n).
SweepSegments prepare_sweep(std::span<const Segment> segments);

/// What meets at an end of a segment. The four lists have no segment in common.
struct SweepPoint {
  Vec2d point;                                               ///< `scale` times as large as in the segments given
  std::span<const std::uint32_t> ending, through, starting;  ///< through: it is inside of these
  std::span<const std::uint32_t> points;                     ///< segments that are this point
};

class SweepVisitor {
 public:
  virtual ~SweepVisitor() = default;
  /// Once for each distinct end, in lexicographic order. Returns whether to go on.
  virtual bool at_point(const SweepPoint& p) = 0;
  /// Once for each pair that crosses where no segment ends. Returns whether to go on.
  virtual bool crossing(std::uint32_t s, std::uint32_t t) = 0;
};

/// O((n + k) log n) for k pairs of segments that meet. Ends for any finite input, even where the predicates are not
/// exact any more: each exchange of neighbours puts a pair of ranks in order that was not.
void sweep(const SweepSegments& segments, SweepVisitor& visitor);

}  // namespace lambert::polygon
