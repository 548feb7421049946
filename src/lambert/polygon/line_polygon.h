#pragma once
/// The parts of a line that lie inside a polygon, whatever vertices and edges lie on the line.

#include "lambert/polygon/ring.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambert::polygon {

/// A part of the line from a to b that has a length, if only one that rounding hides: a at t = 0, b at t = 1.
struct LinePiece {
  double t_from, t_to;
  Vec2d from, to;
  /// What lies on both sides of it; inside both of an interior piece.
  bool inside_left, inside_right;
};

/// Where the boundary meets the line (PG-60).
struct LineEvent {
  enum class Kind : std::uint8_t {
    crossing,  ///< inside of an edge (I)
    vertex,    ///< a vertex whose neighbours lie off the line (V)
    edges,     ///< a run of edges along the line, perhaps to and fro (E)
  };
  /// The context: what the chain of edges does that comes to the line here and leaves it.
  enum class Boundary : std::uint8_t {
    crosses,      ///< it comes from one side and leaves on the other
    stays_left,   ///< a local minimum of the distance to the left
    stays_right,  ///< a local minimum of the distance to the right
    stays_on,     ///< the whole ring lies on the line
  };
  Kind kind;
  Boundary boundary;
  std::size_t ring;
  std::size_t index;  ///< of the edge that crosses, of the vertex, or of the first vertex of the run
  double t;           ///< of `point`
  Vec2d point;        ///< of a run its first vertex
};

struct LineThrough {
  /// The maximal pieces inside, in order along the line; a boundary that only touches a piece does not divide it.
  std::vector<LinePiece> interior;
  /// The maximal pieces on edges, in order; divided where the inside changes sides.
  std::vector<LinePiece> on_edges;
  /// In order along the line.
  std::vector<LineEvent> events;
};

/// Cuts rings by the line through a and b, directed from a to b; nothing when they coincide. Where no vertex lies on
/// the line the interior is what lies between the first and the second crossing, the third and the fourth and so on
/// (PG-59), or between the new vertices of a polygon clipped by the line (PG-57); in general a chain counts half where
/// it comes to the line and half where it leaves, so that only chains that cross change the inside. No coordinate is
/// displaced (PG-58).
///
/// What is inside and in which order is decided exactly; points are rounded (see LineOrder). O(n + k log k) for k edges
/// that meet the line.
LineThrough line_through(const Rings& rings, Vec2d a, Vec2d b, FillRule rule = FillRule::even_odd);

}  // namespace lambert::polygon
