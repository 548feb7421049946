#pragma once
#include "lambert/polygon/decompose/flat_rings.h"

#include <cstddef>

namespace lambert::bench {

/// CGAL's constrained Delaunay triangulation of the rings, all constraints inserted at once (sorted along a curve, its
/// fastest way), and the faces inside marked: their number.
std::size_t cgal_triangle_count(const polygon::FlatRings& rings);

}  // namespace lambert::bench
