#pragma once
#include "lambert/polygon/sweep/sweep.h"

#include <optional>

namespace lambert::polygon {

/// Two edges of one line that share more than a point.
struct EdgeOverlap {
  std::size_t first, second;
  bool successive;  ///< one follows the other in the ring
  Vec2d from;       ///< the lexicographically first point they share
};

/// Of the edges of one ring, in its order: two that overlap; not successive ones, if there are others. The edges are
/// sorted by slope, line and place along it. Exact. O(n log n).
std::optional<EdgeOverlap> find_overlap(const SweepSegments& ring);

}  // namespace lambert::polygon
