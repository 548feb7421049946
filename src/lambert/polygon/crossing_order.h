#pragma once
#include "lambert/base/vec.h"

namespace lambert::polygon {

/// The place of the point where the lines ab and cd cross, which must not be parallel, beside p: -1 when it comes
/// before p in lexicographic order, 1 when after, 0 when it is p. Exact for any finite doubles, although the
/// point itself may not be a pair of doubles.
int compare_crossing(Vec2d a, Vec2d b, Vec2d c, Vec2d d, Vec2d p);

}  // namespace lambert::polygon
