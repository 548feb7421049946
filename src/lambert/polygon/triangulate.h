#pragma once
#include "lambert/polygon/flat_rings.h"
#include "lambert/polygon/triangle.h"

#include <vector>

namespace lambert::polygon {

/// Cuts what the rings enclose by the even-odd rule into triangles of their vertices, which are numbered ring after
/// ring (PG-14). A sweep from left to right that keeps for each interval of the interior the chain of vertices still
/// to be served (Hertel and Mehlhorn, "Fast triangulation of the plane with respect to simple polygons", 1985):
/// O(n log n).
///
/// Rings may be of any orientation and nested in any depth. They may touch or cross themselves and each other in
/// vertices of both, and touch in a vertex of one; edges may lie on each other, and then enclose nothing as far as they
/// do; vertices may be repeated and rings turn back on themselves. Edges must not cross, nor a ring cross an edge in
/// its own vertex. Then the triangles are counter-clockwise, have area (decided exactly) and tile the interior, edge to
/// edge but perhaps where a vertex lies inside a foreign edge; n vertices in one outer ring and h holes that touch
/// nothing give n - 2 + 2 h of them. Where vertices coincide, a triangle may name any of them.
///
/// For other rings the work ends in the same time and all triangles are counter-clockwise, but they may overlap or
/// leave gaps: normalise such rings first. Coordinates must be finite.
std::vector<Triangle> triangulate(const FlatRings& rings);
std::vector<Triangle> triangulate(const Rings& rings);
std::vector<Triangle> triangulate(const Region& region);

}  // namespace lambert::polygon
