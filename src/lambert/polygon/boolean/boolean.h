#pragma once
/// Union, intersection, difference and symmetric difference of any rings (PG-02), and the regions that rings enclose.
///
/// **Input.** Any finite coordinates, rings of any number of vertices, orientation and shape: crossing themselves and
/// each other, with repeated points, collinear runs and edges on top of each other. Rings of fewer than three distinct
/// points enclose nothing.
///
/// **Output** is valid, and check_valid of valid.h says so: outer rings run counter-clockwise, holes clockwise inside
/// their outer ring; the interior of a region is connected; no ring visits a point twice (rings are split where they
/// touch themselves); rings meet in points at most and never cross; no vertex lies on the straight line between its
/// neighbours. A ring starts at its lexicographically smallest vertex, and rings are sorted. So the same set has one
/// form only, and normalised() gives back exactly what it is given when that is a result already. Exchanging subject
/// and clip of a symmetric operation changes nothing, to the bit.
///
/// **Exactness.** All decisions are exact (predicates.h); vertices of the input keep their coordinates. Where two edges
/// cross, the point is rounded to doubles: it lies within 2^-48 of the extent of the two edges from both of them, and
/// in the box of each. Rounding moves edges; where a moved edge meets what it did not meet before, it is cut again,
/// until nothing crosses. This ends, since the boxes of the parts shrink with every cut and there are finitely many
/// doubles, and it ends soon: edges not within some units in the last place of each other need one or two rounds. From
/// the fourth round on parts also go through ends of others within 2^-51 of the largest coordinate of the two, twice as
/// far in every further round up to 2^-40; from the thirteenth, which random degenerate inputs reach once in some
/// thousands, all points go to a square grid of 2^-46 of the largest coordinate of all, doubled with every further
/// round. A cut moves an edge by no more than that; cuts may add up. Coordinates more than 420 binary orders of
/// magnitude below the largest one are first rounded to a grid 2^-472 of its size.
///
/// **Time** O((n + k) log n) expected for n edges with k crossings and each round; for outlines that are coherent, as
/// most are, less than 0.1 us an edge.

#include "lambert/polygon/ring.h"

namespace lambert::polygon {

enum class BooleanOp : std::uint8_t {
  unite,      ///< in the subject or in the clip
  intersect,  ///< in both
  subtract,   ///< in the subject, not in the clip
  exclude,    ///< in one of them, not in both
};

/// `rule` says what the rings of each operand enclose by themselves. Throws std::invalid_argument when a coordinate is
/// not finite.
Regions boolean(BooleanOp op, const Rings& subject, const Rings& clip, FillRule rule = FillRule::even_odd);

/// What `rings` enclose, as valid regions. Throws as boolean does.
Regions normalised(const Rings& rings, FillRule rule = FillRule::even_odd);

inline Regions unite(const Rings& a, const Rings& b, FillRule rule = FillRule::even_odd) {
  return boolean(BooleanOp::unite, a, b, rule);
}
inline Regions intersect(const Rings& a, const Rings& b, FillRule rule = FillRule::even_odd) {
  return boolean(BooleanOp::intersect, a, b, rule);
}
inline Regions subtract(const Rings& a, const Rings& b, FillRule rule = FillRule::even_odd) {
  return boolean(BooleanOp::subtract, a, b, rule);
}
inline Regions exclude(const Rings& a, const Rings& b, FillRule rule = FillRule::even_odd) {
  return boolean(BooleanOp::exclude, a, b, rule);
}

}  // namespace lambert::polygon
