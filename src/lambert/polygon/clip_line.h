#pragma once
/// The straight boundary of clipping: which side of it a point lies on, exactly, and where an edge crosses it, rounded.

#include "lambert/polygon/predicates.h"

namespace lambert::polygon {

/// The line from tail to head. Clipping keeps what lies left of it, the line itself included. Where both ends coincide
/// every point lies on it.
struct ClipLine {
  Vec2d tail, head;

  bool is_vertical() const { return tail.x == head.x; }
  bool is_horizontal() const { return tail.y == head.y; }
  /// Left and right exchanged.
  ClipLine flipped() const { return {head, tail}; }

  /// 1 left of the line (kept), 0 on it, -1 right of it. Exact.
  int side(Vec2d p) const {
    if (is_vertical()) return compare(tail.x, p.x) * compare(head.y, tail.y);
    if (is_horizontal()) return compare(p.y, tail.y) * compare(head.x, tail.x);
    return orientation(tail, head, p);
  }

  /// Where the segment ab, whose ends lie on different sides, meets the line. The result is the same to the last bit
  /// for ab and ba and for the flipped line, lies in the box of a and b, within 4 units in the last place of the
  /// largest coordinate of a and b from the exact point, and exactly on lines parallel to an axis.
  Vec2d crossing(Vec2d a, Vec2d b) const;

  /// Orders points of the line from tail to head: -1 when a comes first, 0 when equal. Exact for points exactly on the
  /// line, a total order for any.
  int compare_along(Vec2d a, Vec2d b) const;

 private:
  static int compare(double a, double b) { return a < b ? -1 : (a > b ? 1 : 0); }
};

inline ClipLine keep_x_from(double x) { return {{x, 1}, {x, 0}}; }
inline ClipLine keep_x_to(double x) { return {{x, 0}, {x, 1}}; }
inline ClipLine keep_y_from(double y) { return {{0, y}, {1, y}}; }
inline ClipLine keep_y_to(double y) { return {{1, y}, {0, y}}; }

}  // namespace lambert::polygon
