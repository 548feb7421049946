#pragma once
#include "lambert/polygon/ring.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace lambert::polygon {

/// Whether a ring meets itself (PG-05), and a witness. Where several answers hold the one that stands latest in the
/// list is given: a ring is an edges_cross only when no two of its edges coincide.
struct Simplicity {
  enum class Kind : std::uint8_t {
    simple,          ///< edges meet only where one ends and the next begins
    too_few,         ///< fewer than three vertices
    vertex_twice,    ///< two vertices coincide, be they neighbours or not
    edges_cross,     ///< two edges meet inside of one of them at least
    spike,           ///< two successive edges fold back on each other: they share more than a vertex
    edges_coincide,  ///< two edges that do not follow on each other share more than a point
  };
  Kind kind = Kind::simple;
  /// Vertices of vertex_twice, edges of the last three; first < second.
  std::size_t first = 0, second = 0;
  /// Where they meet; of coinciding edges the lexicographically first such point. A crossing of both interiors is
  /// rounded (see SegmentMeeting), all other points are vertices.
  Vec2d point{0};

  bool simple() const { return kind == Kind::simple; }
};

/// By a sort of the edges by their lines and a plane sweep that stops at the first crossing (Shamos and Hoey 1976;
/// PG-07). Exact. O(n log n).
Simplicity check_simple(const Ring& ring);

/// The same kind, perhaps by another witness, by trying every pair (PG-06). Exact. O(n^2).
Simplicity check_simple_by_pairs(const Ring& ring);

/// For people: "edges 3 and 7 cross at (2, 1.5)"; empty when simple.
std::string message_of(const Simplicity& s);

}  // namespace lambert::polygon
