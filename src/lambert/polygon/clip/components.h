#pragma once
#include "lambert/polygon/ring.h"

namespace lambert::polygon {

/// Sorts rings that do not cross (outer ones counter-clockwise, holes clockwise) into connected pieces: each
/// counter-clockwise ring is the outer ring of one, and each clockwise ring is a hole of the smallest piece that
/// contains it. A clockwise ring within none is left out, as are rings without area. Rings may touch. Containment is
/// decided exactly. O(r n) for r holes in the worst case; boxes usually leave one candidate.
Regions components(const Rings& rings);

}  // namespace lambert::polygon
