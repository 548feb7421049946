#pragma once
/// Where edges of an outline meet.

#include "lambert/polygon/arrangement/boxes.h"
#include "lambert/polygon/arrangement/index.h"

#include <optional>
#include <span>
#include <vector>

namespace lambert::polygon::arrangement {

/// A point at which an edge of the outline is to be cut, or its start point when something else goes through that.
struct Mark {
  std::uint32_t edge;
  bool rounded;  ///< not exactly where edges meet
  Vec2d point;
};

/// Sorted by edge and along it, each once. Cutting every edge there leaves parts that meet in their ends only, all of
/// them marked.
struct Marks {
  std::vector<Mark> all;
  std::vector<bool> inside;  ///< for every edge, whether a mark lies inside it: not at its start

  /// Those inside an edge.
  std::span<const Mark> inside_of(std::uint32_t edge, Vec2d start) const;
};

/// Every crossing is rounded once. Nothing when the box tree is no good for this outline, or when rounding went on
/// making new crossings: then `subdivide` is the way. Expected time O(n + k log k) for outlines the tree is good for;
/// in any case O(n log n).
std::optional<Marks> find_marks(const Outline& outline, const BoxTree& tree, double patience = 1);

}  // namespace lambert::polygon::arrangement
