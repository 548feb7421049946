#pragma once
/// The notes' decomposition into trapezoids: a horizontal line sweeps upwards and cuts the polygon at the height of
/// every vertex (rows PG-22 to PG-32, with errata E-PG-10, 11, 12 and 15).

#include "lambert/polygon/decompose/flat_rings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace lambert::polygon {

/// What the sweep line meets at a vertex; the numbers are those of the notes. Edges end and begin as TieBreak orders
/// their vertices.
enum class SweepCase : std::uint8_t {
  none,              ///< an end of edges without length
  left_edge,         ///< one edge ends, one begins, the interior is right of them
  right_edge,        ///< the same with the interior on the left
  interior_minimum,  ///< two edges begin with the interior between them
  exterior_minimum,  ///< two edges begin with the exterior between them: a notch
  interior_maximum,  ///< two edges end with the interior between them
  exterior_maximum,  ///< two edges end with the exterior between them
};

/// What to do about vertices of the same height, which the notes' cases exclude.
enum class TieBreak : std::uint8_t {
  /// The left one counts as lower, as if the plane were turned by an angle too small to change anything else; what has
  /// no height then is left out. Exact.
  symbolic,
  /// The notes' way (PG-23): turn the plane about vertex 0 by a random angle, again while heights are equal, and turn
  /// the pieces back. Slabs are then oblique. Turning rounds, by some 1e-16 of the size: only for rings that do not
  /// touch and have no collinear runs.
  random_rotation,
};

struct Trapezoid {
  std::array<Vec2d, 4> corners;  ///< counter-clockwise from the upper left one
  std::size_t size = 0;          ///< 3 or 4
};

struct TrapezoidOptions {
  TieBreak tie_break = TieBreak::symbolic;
  std::uint64_t seed = 1;  ///< of random_rotation
};

/// Hands the pieces of what the rings enclose by the even-odd rule to `sink`, slab by slab from below and each slab
/// from left to right; returns the case of every vertex. Rings may touch but not cross, else pieces are wrong.
///
/// Pieces have area, are convex and tile the interior. Corners are vertices or points of edges at the height of a
/// vertex, which are rounded: their x by some units in the last place of the edge's coordinates, their y not at all
/// (before random_rotation turns back). Pieces of neighbouring slabs and those on both sides of a vertex share such
/// points exactly. Order is decided exactly, and rounding is kept from changing it.
///
/// n vertices give n slabs, each with as many pieces as it crosses the polygon: O(n^2) time at worst, O(n) memory.
std::vector<SweepCase> trapezoids(const FlatRings& rings, const std::function<void(const Trapezoid&)>& sink,
                                  TrapezoidOptions options = {});

struct Trapezoids {
  std::vector<Trapezoid> pieces;
  std::vector<SweepCase> cases;  ///< of the vertices in the order of flat(region)
};
Trapezoids trapezoids(const Region& region, TrapezoidOptions options = {});

}  // namespace lambert::polygon
