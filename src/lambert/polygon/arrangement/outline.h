#pragma once
/// The rings of both operands in one flat array, scaled so that predicates are exact.

#include "lambert/polygon/arrangement/crossing.h"
#include "lambert/polygon/arrangement/winding.h"

#include <cstdint>
#include <vector>

namespace lambert::polygon::arrangement {

/// Edge i joins points i and i + 1; every ring is closed by its first point again, so that `starts[r + 1] - 1` names no
/// edge. No edge has length 0, no ring has fewer than two edges.
struct Outline {
  std::vector<Vec2d> points;
  std::vector<std::uint32_t> starts;  ///< of each ring; one more at the end
  std::uint32_t clip_begin = 0;       ///< the first point of the clip
  Grid grid;                          ///< of all points, also of those to come
  int exponent = 0;                   ///< points are those given times 2^-exponent

  std::size_t ring_count() const { return starts.size() - 1; }
  Winding winding_of(std::size_t edge) const { return edge < clip_begin ? Winding{1, 0} : Winding{0, 1}; }
};

/// Throws std::invalid_argument when a coordinate is not finite, std::length_error beyond 2^31 points.
Outline outline_of(const Rings& subject, const Rings& clip);

/// Back to the scale of the input.
void unscale(const Outline& outline, Regions& regions);

}  // namespace lambert::polygon::arrangement
