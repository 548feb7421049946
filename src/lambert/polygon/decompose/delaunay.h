#pragma once
#include "lambert/polygon/decompose/flat_rings.h"
#include "lambert/polygon/decompose/triangle.h"

#include <vector>

namespace lambert::polygon {

/// As triangulate(), but constrained Delaunay: the circle through the corners of a triangle has no vertex inside that
/// can be seen from the triangle's interior, so that the smallest angle is as large as a triangulation of these
/// vertices allows (Lee and Lin 1986). Where four vertices lie on one circle, either diagonal may stand. Decided
/// exactly.
///
/// Lawson's flips (1977), beginning with triangulate(): n^2 of them in the worst case, about 2 n or fewer in all
/// polygons measured, which leave few diagonals to choose. Where vertices coincide, the triangles name the first.
std::vector<Triangle> delaunay(const FlatRings& rings);
std::vector<Triangle> delaunay(const Rings& rings);
std::vector<Triangle> delaunay(const Region& region);

}  // namespace lambert::polygon
