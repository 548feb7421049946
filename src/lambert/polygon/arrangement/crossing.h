#pragma once
/// Where two edges cross, rounded.

#include "lambert/polygon/predicates/predicates.h"

#include <algorithm>
#include <cmath>

namespace lambert::polygon::arrangement {

/// Rounds to multiples of a power of two `quantum` what is smaller than 2^51 of them, and leaves larger doubles, which
/// are multiples of it anyway.
class Grid {
 public:
  explicit Grid(double quantum = 0x1p-472) : quantum_(quantum), magic_(0x1.8p52 * quantum), limit_(0x1p51 * quantum) {}

  double quantum() const { return quantum_; }

  double operator()(double x) const { return std::abs(x) < limit_ ? (x + magic_) - magic_ : x; }
  Vec2d operator()(Vec2d p) const { return {(*this)(p.x), (*this)(p.y)}; }

 private:
  double quantum_, magic_, limit_;
};

struct Segment {
  Vec2d a, b;
};

/// Whether p lies in the box of the segment, borders included.
inline bool in_box(Segment s, Vec2d p) {
  return std::min(s.a.x, s.b.x) <= p.x && p.x <= std::max(s.a.x, s.b.x) && std::min(s.a.y, s.b.y) <= p.y &&
         p.y <= std::max(s.a.y, s.b.y);
}

/// Whether both cross in their interiors. Exact.
inline bool segments_cross(Segment s, Segment t) {
  return orientation(s.a, s.b, t.a) * orientation(s.a, s.b, t.b) < 0 &&
         orientation(t.a, t.b, s.a) * orientation(t.a, t.b, s.b) < 0;
}

/// Where two segments that cross do so, rounded: a point in the boxes of both, within 2^-48 of the extent of their
/// joint box from both. The order of the segments and of their ends changes nothing.
Vec2d crossing_point(Segment s, Segment t);

/// The same of parts of two lines that have moved a little off them by rounding: on the lines, so that errors do not
/// add up from part to part, unless only the parts cross where both have their boxes.
Vec2d crossing_of_parts(Segment s, Segment t, Segment line_of_s, Segment line_of_t);

}  // namespace lambert::polygon::arrangement
