#pragma once
/// Whether regions are what boolean.h promises.

#include "lambert/polygon/ring.h"

#include <cstdint>
#include <optional>
#include <string>

namespace lambert::polygon {

enum class Defect : std::uint8_t {
  not_finite,      ///< a coordinate
  too_few_points,  ///< a ring of fewer than three vertices, or equal ones in succession
  ring_meets_itself,
  rings_cross,
  edges_overlap,  ///< of one ring or of two
  orientation,    ///< an outer ring that is not counter-clockwise, or a hole that is not clockwise
  nesting,        ///< a ring whose left side is not in its region alone, or whose right side is in any
  disconnected,   ///< holes that touch each other or the outer ring so that the interior falls apart
};

struct Invalidity {
  Defect defect;
  std::size_t region;
  std::size_t ring;  ///< 0 the outer ring, i the hole i - 1
  Vec2d at;          ///< where it shows

  std::string message() const;
};

/// The first defect found, by exact predicates, if any: of regions whose coordinates span at most 420 binary orders of
/// magnitude. Straight vertices and any start and order of rings are allowed. O(n log n) and a pass over the edges that
/// each edge overlaps in x, n^2 at worst: for tests.
std::optional<Invalidity> check_valid(const Regions& regions);

}  // namespace lambert::polygon
