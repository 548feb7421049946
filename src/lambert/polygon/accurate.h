#pragma once
#include "lambert/base/vec.h"

namespace lambert::polygon {

/// The z component of (b - a) x (d - c), within 2^-48 of its size however much cancels: a rounded value where that is
/// good enough, expansion arithmetic where not. Its sign is exact. Range as for the predicates.
double accurate_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d);

}  // namespace lambert::polygon
