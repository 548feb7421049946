#pragma once
#include "lambert/base/vec.h"
#include "lambert/polygon/decompose/triangle.h"

#include <span>
#include <vector>

namespace lambert::polygon {

/// Cuts a simple polygon, counter-clockwise, into size - 2 triangles of indices into `corners`: the two-ears theorem
/// (Meisters 1975) with a queue of candidates and a grid of reflex corners, about n log n in practice. Touching corners
/// and bridges to holes are allowed. Ears are decided exactly; corners that leave no proper ear, as in collinear runs
/// and in what is not simple, are cut off all the same, so that the number of triangles is always size - 2 (none for
/// fewer than 3 corners); such triangles may be flat or overlap. Ends in bounded time for any numbers.
///
/// triangulate() is faster and takes holes; this is for faces that must keep their number of triangles.
std::vector<Triangle> clip_ears(std::span<const Vec2d> corners);

}  // namespace lambert::polygon
