#pragma once
/// Decisions on points of the plane that are exact for any finite doubles: a rounded value decides when it exceeds its
/// error bound, expansion arithmetic when not (Shewchuk 1997), in doubles where products of differences of the
/// coordinates (two factors in orientation, four in in_circle) with all their roundings are doubles, as they are of
/// sizes 2^-200 to 2^200, else in numbers of a wider exponent. Those cost some microseconds: algorithms that decide
/// often bring their points to a safe scale first (scale.h).

#include "lambert/base/vec.h"

namespace lambert::polygon {

namespace exact {
int orientation(Vec2d a, Vec2d b, Vec2d c);
}

/// The z component of (b - a) x (c - a), rounded: twice the area of the triangle, with its sign but for rounding.
inline double cross(Vec2d a, Vec2d b, Vec2d c) { return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x); }

/// 1 when a, b, c turn left (counter-clockwise; c is left of the line from a to b), -1 when right, 0 when collinear.
/// Exact.
inline int orientation(Vec2d a, Vec2d b, Vec2d c) {
  constexpr double unit = 0x1p-53, bound = (3 + 16 * unit) * unit;
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  // The constant covers products below 2^-1022, which are off by up to 2^-1075 each.
  const double determinant = left - right, limit = bound * (std::abs(left) + std::abs(right)) + 0x1p-1072;
  if (determinant > limit) return 1;
  if (-determinant > limit) return -1;
  return exact::orientation(a, b, c);
}

/// 1 when d lies inside the circle through a, b, c, which turn left; -1 when outside, 0 when on it. Signs swap when
/// they turn right. Exact.
int in_circle(Vec2d a, Vec2d b, Vec2d c, Vec2d d);

/// Lexicographic: -1 when a is left of b, or exactly above nothing but lower; 1 the other way, 0 when equal.
inline int compare_xy(Vec2d a, Vec2d b) {
  if (a.x != b.x) return a.x < b.x ? -1 : 1;
  return a.y < b.y ? -1 : (a.y > b.y ? 1 : 0);
}

/// Whether p, which is collinear with a and b, lies between them or on one of them. Exact.
inline bool between(Vec2d a, Vec2d b, Vec2d p) { return compare_xy(a, p) * compare_xy(p, b) >= 0; }

/// Whether p lies on the segment ab, its ends included. Exact.
inline bool on_segment(Vec2d a, Vec2d b, Vec2d p) { return orientation(a, b, p) == 0 && between(a, b, p); }

/// The sign of (b - a) . (d - c). Exact.
int dot_sign(Vec2d a, Vec2d b, Vec2d c, Vec2d d);

/// Compares the directions b - a and d - c by their turn: 1 when the second lies counter-clockwise of the first, by
/// less than half a revolution; -1 when clockwise, 0 when they are parallel or opposite. Exact.
int turn_sign(Vec2d a, Vec2d b, Vec2d c, Vec2d d);

}  // namespace lambert::polygon
