#pragma once
/// The step that follows the clipping of rings by a line: bridges removed, pieces taken apart (used by window_clip.h).

#include "lambert/polygon/clip/clip_line.h"
#include "lambert/polygon/ring.h"

#include <vector>

namespace lambert::polygon {

/// A vertex of which it is known, not computed from its rounded position, whether it lies on the line.
struct SidedVertex {
  Vec2d position{0};
  int side = 0;
};

/// Rings clipped by `line` (no vertex with side -1). Where edges on the line cover each other in opposite directions
/// they cancel; what is left is joined at each point of the line so that neighbouring directions bound one piece.
/// Winding numbers left of the line do not change.
Rings without_bridges(const std::vector<std::vector<SidedVertex>>& clipped, const ClipLine& line);

}  // namespace lambert::polygon
