#pragma once
/// Numbers computed from cross products, right however much cancels and whatever the sizes of coordinates.

#include "lambert/base/vec.h"

namespace lambert::polygon {

/// The z component of (b - a) x (d - c), within 2^-48 of its size: a rounded value where that is good enough,
/// expansion arithmetic where not. Its sign is exact. Coordinates must be 0 or of sizes 2^-480 to 2^490.
double accurate_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d);

/// (b - a) x (d - c).
struct CrossProduct {
  Vec2d a, b, c, d;
};

/// n / m within 2^-46 of its size, of any finite coordinates; m is not 0.
double accurate_quotient(const CrossProduct& n, const CrossProduct& m);

/// a + t (b - a) for t in [0, 1], from the nearer end, so that the rounding of t counts little, and inside the box of a
/// and b. Of any finite coordinates.
Vec2d point_between(Vec2d a, Vec2d b, double t);

}  // namespace lambert::polygon
