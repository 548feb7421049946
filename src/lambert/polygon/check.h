#pragma once
#include "lambert/base/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace lambert::polygon {

/// Whether a list of vertices is a closed chain of edges that all have a length (PG-04). The first fault counts, in
/// this order: too few vertices, not closed, a vertex repeated; but three vertices that are not closed want closing.
struct ChainCheck {
  enum class Fault : std::uint8_t {
    none,
    too_few,          ///< fewer than three vertices, the repetition of the first not counted
    not_closed,       ///< the last vertex of a closed list is not the first
    repeated_vertex,  ///< two vertices in succession coincide: an edge without length
  };
  Fault fault = Fault::none;
  /// Of not_closed: the last vertex. Of repeated_vertex: the first of the two, so that the edge at fault has this
  /// index.
  std::size_t index = 0;

  explicit operator bool() const { return fault == Fault::none; }
  bool operator==(const ChainCheck&) const = default;
};

/// Lists whose last vertex repeats the first: a triangle has four entries (E-PG-01). O(n).
ChainCheck check_closed_list(std::span<const Vec2d> list);
ChainCheck check_closed_list(std::span<const Vec3d> list);

/// Rings, whose last vertex joins the first without repeating it: a ring that does repeat it has an edge without
/// length, its last. O(n).
ChainCheck check_ring(std::span<const Vec2d> ring);
ChainCheck check_ring(std::span<const Vec3d> ring);

/// For people: "vertices 3 and 4 coincide"; empty when there is no fault. `size` is that of what was checked.
std::string message_of(const ChainCheck& check, std::size_t size);

}  // namespace lambert::polygon
