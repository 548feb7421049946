#pragma once
/// Closed walks along a boundary, with the set on the left.

#include "lambert/polygon/arrangement/boundary.h"
#include "lambert/polygon/arrangement/status.h"

namespace lambert::polygon::arrangement {

/// For every arc the one that continues it: of those that leave its last node, the next clockwise from it, so that the
/// walk stays in the wedge of the set that it came along. Together the walks are then the boundary components of the
/// connected parts of the set's interior.
std::vector<std::uint32_t> next_arcs(const Boundary& boundary);

}  // namespace lambert::polygon::arrangement
