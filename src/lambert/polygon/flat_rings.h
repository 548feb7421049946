#pragma once
/// Rings whose vertices stand in one array, so that a number names a vertex.

#include "lambert/polygon/ring.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambert::polygon {

/// Ring r has the vertices ends[r - 1] (0 for the first) up to, not including, ends[r]. Fewer than 2^32 vertices.
struct FlatRings {
  std::vector<Vec2d> vertices;
  std::vector<std::uint32_t> ends;
};

/// In the order given: the outer ring of a region first, then its holes.
FlatRings flat(const Rings& rings);
FlatRings flat(const Region& region);

FlatRings scaled(FlatRings rings, double factor);

/// The vertex that follows each one around its ring.
std::vector<std::uint32_t> successors(const FlatRings& rings);

}  // namespace lambert::polygon
