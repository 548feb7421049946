#pragma once
/// Simple rings out of arcs.

#include "lambert/polygon/arrangement/boundary.h"

namespace lambert::polygon::arrangement {

struct Loop {
  Ring ring;               ///< canonical: starts at its smallest vertex, no vertex straight between its neighbours
  bool is_hole = false;    ///< clockwise
  std::uint32_t walk = 0;  ///< which of the closed walks it is part of
  std::uint32_t arc = 0;   ///< the arc that arrives at the first vertex or runs through it
};

/// The ring along consecutive arcs that end where the first one begins.
Loop loop_of(const Boundary& boundary, std::span<const std::uint32_t> arcs, Ring& scratch);

}  // namespace lambert::polygon::arrangement
