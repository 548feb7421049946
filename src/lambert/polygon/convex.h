#pragma once
#include "lambert/polygon/ring.h"

#include <array>
#include <cstddef>
#include <vector>

namespace lambert::polygon {

/// The angle in radians, in (-pi, pi], by which the direction turns at b on the way from a over b to c: positive to the
/// left; 0 when two of them coincide. Rounded, but its sign is exact unless
/// the angle is below 2^-1074.
double turning_angle(Vec2d a, Vec2d b, Vec2d c);

/// The sum of all turning angles in radians: 2 pi times revolutions(ring), but for rounding.
double total_turning(const Ring& ring);

/// How often the edges' direction revolves on the way round, counter-clockwise counted positive: 1 or -1 for a simple
/// ring, 2 for a pentagram, 0 for an eight. An edge that folds back counts as half a revolution to the left. Edges
/// without length are passed over. Exact. O(n).
int revolutions(const Ring& ring);

/// The notes' test (PG-15): no two turns have opposite signs. Not enough for convexity: a pentagram turns one way, too.
/// Exact. O(n).
bool turns_one_way(const Ring& ring);

/// Whether the ring bounds a convex region with area: all turns one way, one revolution in total (E-PG-07) and no edge
/// folded back. Either orientation; straight corners and repeated vertices are allowed. Exact. O(n).
bool is_convex(const Ring& ring);

/// 1 when a simple ring is counter-clockwise, -1 when clockwise: the turn at its lowest left vertex, exact. Rings that
/// have no turn there (they fold back, or visit it twice) go by their rounded area; 0 when that is 0. O(n).
int ring_orientation(const Ring& ring);

/// The vertices of a simple ring, of either orientation, whose inner angle exceeds half a revolution, in order. Exact.
/// O(n).
std::vector<std::size_t> reflex_vertices(const Ring& ring);

/// Two triangles of a simple quad that tile it, given by their vertices and oriented as the quad. Its diagonal starts
/// at the reflex vertex, if there is one (PG-20), else at a straight one, else at vertex 0: from there, i, the
/// triangles are (i, i + 1, i + 2) and (i, i + 2, i + 3). Exact.
struct QuadSplit {
  std::size_t start;
  std::array<std::array<std::size_t, 3>, 2> triangles;
};
QuadSplit split_quad(const std::array<Vec2d, 4>& quad);

}  // namespace lambert::polygon
