#pragma once
/// Clipping of rings to a half-plane or a convex window, without the bridges of Sutherland and Hodgman: what falls
/// apart comes back as several rings, and no edge runs along the boundary there and back.
///
/// In all of these the winding number of the result about a point inside the window is that of the input, whatever the
/// rings do, so that any FillRule encloses the same there; outside the window it is 0. Rings with the interior on one
/// side (outer rings counter-clockwise and holes clockwise, or all the other way) keep it on that side and, if they did
/// not cross, do not cross, but for the rounding of crossings on lines that are not parallel to an axis. Pieces that
/// meet only in a point of the boundary come apart. Rings that nothing cuts off are returned as they were; the vertices
/// that a cut leaves inside an edge along the boundary are left out. O((n + k) log n) for each half-plane, with k
/// crossings.

#include "lambert/polygon/clip/clip_line.h"
#include "lambert/polygon/ring.h"

namespace lambert::polygon {

Rings clip_to_half_plane(const Rings& rings, const ClipLine& line);

/// The rectangle min <= p <= max, exactly: no coordinate of the result lies outside. Empty when min exceeds max.
Rings clip_to_rectangle(const Rings& rings, Vec2d min, Vec2d max);

/// A convex counter-clockwise window. Repeated and collinear vertices are allowed; a window without area keeps nothing.
Rings clip_to_convex(const Rings& rings, const Ring& window);

}  // namespace lambert::polygon
