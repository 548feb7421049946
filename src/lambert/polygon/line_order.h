#pragma once
#include "lambert/base/vec.h"

namespace lambert::polygon {

/// A point of a directed line: a vertex that lies on it, or where an edge crosses it.
struct LinePlace {
  Vec2d right, left;  ///< the edge's ends, by their sides of the line; the vertex twice
  bool is_vertex() const { return right == left; }
};

/// The places of a line in order, all decisions exact for any finite doubles. a and b differ.
class LineOrder {
 public:
  LineOrder(Vec2d a, Vec2d b) : a_(a), b_(b) {}
  /// -1 when p comes first on the way from a to b, 1 when q does, 0 when they are one point.
  int compare(const LinePlace& p, const LinePlace& q) const;
  /// The parameter of p: 0 at a and 1 at b. Within 2^-46 of its size, and of 1 for a vertex.
  double parameter(const LinePlace& p) const;
  /// A vertex as it is. A crossing is rounded, to within 2^-45 of the length of the edge and a unit in the last place,
  /// and inside the edge's box; on a horizontal or vertical line it has exactly the line's coordinate.
  Vec2d point(const LinePlace& p) const;

 private:
  int compare_crossings(const LinePlace& p, const LinePlace& q) const;
  Vec2d a_, b_;
};

}  // namespace lambert::polygon
