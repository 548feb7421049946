#pragma once
/// Where edges of an outline meet.

#include "lambert/polygon/arrangement/boxes.h"

#include <optional>
#include <vector>

namespace lambert::polygon::arrangement {

/// A point at which an edge of the outline is to be cut, or its start point when something else goes through that.
struct Mark {
  std::uint32_t edge;
  Vec2d point;
  bool rounded = false;  ///< not exactly where edges meet
};

/// Sorted by edge and along it, each once. Cutting every edge there leaves parts that meet in their ends only, all of
/// them marked; every crossing is rounded once. Nothing when the box tree is no good for this outline, or when rounding
/// went on making new crossings: then `subdivide` is the way. Expected time O(n + k log k) for outlines the tree is
/// good for; in any case O(n log n).
std::optional<std::vector<Mark>> find_marks(const Outline& outline, const BoxTree& tree);

/// Of the edge, in the sorted marks, those inside it: not at its start.
std::pair<std::size_t, std::size_t> inner_marks(const Outline& outline, const std::vector<Mark>& marks,
                                                std::uint32_t edge);

}  // namespace lambert::polygon::arrangement
