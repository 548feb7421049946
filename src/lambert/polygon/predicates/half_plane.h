#pragma once
#include "lambert/polygon/predicates/predicates.h"

#include <cstdint>

namespace lambert::polygon {

enum class Side : std::int8_t { right = -1, on = 0, left = 1 };

/// On which side of the directed line from tail to head p lies, with y up; `on` when tail and head coincide. Exact.
inline Side side_of_line(Vec2d tail, Vec2d head, Vec2d p) { return static_cast<Side>(orientation(tail, head, p)); }

/// The z component of (p - tail) x (head - tail), rounded: with the point first, it is positive to the right of the
/// line and negative to its left, where y points up (PG-43); with y down the sides swap. Its size is |head - tail|
/// times the distance from the line. Its sign may be lost to rounding: side_of_line() decides.
inline double half_plane_cross(Vec2d tail, Vec2d head, Vec2d p) { return cross(p, head, tail); }

}  // namespace lambert::polygon
