#pragma once
/// Picking edges with a pointer, whose pixel is never exactly on a line (PG-40).

#include "lambert/polygon/box.h"

#include <cstddef>
#include <optional>

namespace lambert::polygon {

/// The region around a segment that catches a point: a disk about either end and a rectangle along it. Both in the
/// segment's own units, with radius > width.
struct GravityField {
  double radius;  ///< of the disks, whose boundary is not part of them
  double width;  ///< of the rectangle across, from side to side: half of it on either side (E-PG-14); boundary included
};

/// What a window of the plane and the viewport that shows it, in pixels, make of a field of so many pixels: where the
/// two scales differ the larger one counts, so that on the screen the field is nowhere thinner than asked for. The
/// viewport must have an area.
GravityField field_of_pixels(double radius_pixels, double width_pixels, const Box2& window, const Box2& viewport);

/// Whether p lies in the field about the segment ab (PG-41); a segment that is a point has only its disk.
bool is_picked(const GravityField& field, Vec2d a, Vec2d b, Vec2d p);

/// Of the edges of a ring that p picks, the nearest one; the first of several. O(n).
std::optional<std::size_t> picked_edge(const GravityField& field, const Ring& ring, Vec2d p);

}  // namespace lambert::polygon
