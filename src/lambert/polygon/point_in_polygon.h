#pragma once
/// Whether a point lies in a polygon, in time proportional to its edges. For many points of one polygon see
/// PointLocator. Everything here is exact for any finite coordinates.

#include "lambert/polygon/box.h"
#include "lambert/polygon/predicates.h"

#include <cstddef>
#include <cstdint>

namespace lambert::polygon {

enum class Place : std::uint8_t { outside, on, inside };

inline bool is_inside(int winding, FillRule rule) {
  return rule == FillRule::even_odd ? winding % 2 != 0 : winding != 0;
}

/// How often rings wind around p, counter-clockwise counted positive; `on` when p lies on an edge, and then the number
/// says nothing.
struct Winding {
  int number = 0;
  bool on = false;
};
Winding winding_around(const Rings& rings, Vec2d p);
Winding winding_around(const Ring& ring, Vec2d p);

/// Inside, outside or on an edge, holes and rings that cross themselves included. O(n).
Place locate(const Rings& rings, Vec2d p, FillRule rule = FillRule::even_odd);
Place locate(const Ring& ring, Vec2d p, FillRule rule = FillRule::even_odd);

/// How many edges p lies beside, on their right, within their strip: the part of the plane between the heights of the
/// edge's ends, the lower excluded and the upper included (PG-44). Odd inside, even outside. O(n).
std::size_t strips_around(const Ring& ring, Vec2d p);

/// Shimrat's routine (Communications of the ACM 5, 1962, algorithm 112, corrected; PG-45). Points on the boundary go
/// with their strips: in an upright square those on the upper and right sides are inside, those on the lower and left
/// sides outside. So of polygons that tile a region each point is in exactly one. O(n).
inline bool shimrat(const Ring& ring, Vec2d p) { return strips_around(ring, p) % 2 != 0; }

/// The same answer for every point, boundary included, by the box of the ring first (PG-47): only points outside the
/// closed box are culled (E-PG-18).
inline bool shimrat_with_cull(const Ring& ring, const Box2& box, Vec2d p) {
  return box.contains(p) && shimrat(ring, p);
}

}  // namespace lambert::polygon
