#pragma once
#include "lambert/polygon/flat_rings.h"
#include "lambert/polygon/triangle.h"

#include <vector>

namespace lambert::polygon {

/// Cuts what the rings enclose by the even-odd rule into triangles of their vertices, which are numbered ring after
/// ring (PG-14). A sweep from left to right that keeps for each interval of the interior the chain of vertices still to
/// be served (Hertel and Mehlhorn, "Fast triangulation of the plane with respect to simple polygons", 1985): O(n log
/// n).
///
/// Rings may be of any orientation and nested in any depth, may touch themselves and each other, and may repeat
/// vertices or turn back on themselves; they must not cross. Then the triangles are counter-clockwise, have area
/// (decided exactly), tile the interior and meet edge to edge, but for vertices that lie on a foreign edge; n vertices
/// in one outer ring and h holes that do not touch give n - 2 + 2 h triangles. Where vertices coincide, a triangle may
/// name any of them.
///
/// For rings that cross, the work ends in the same time and all triangles are counter-clockwise, but they may overlap
/// or leave gaps: normalise such rings first.
std::vector<Triangle> triangulate(const FlatRings& rings);
std::vector<Triangle> triangulate(const Rings& rings);
std::vector<Triangle> triangulate(const Region& region);

}  // namespace lambert::polygon
