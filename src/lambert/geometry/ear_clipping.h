#pragma once
#include "lambert/base/vec.h"
#include "lambert/geometry/mesh.h"

#include <span>
#include <vector>

namespace lambert {

/// Cuts a simple polygon, counter-clockwise in the plane, into size - 2 triangles of indices into `corners` (Meisters
/// 1975, with a queue of candidates and a grid of reflex corners: about n log n in practice). Touching corners and
/// bridges to holes are allowed. Ends in bounded time for anything finite; for what is not simple the triangles
/// overlap.
std::vector<Triangle> clip_ears(std::span<const Vec2d> corners);

}  // namespace lambert
