#pragma once
/// How the readers make paths of positions.

#include "lambert/polygon/formats/features.h"

#include <limits>
#include <span>

namespace lambert::polygon {

/// The third coordinate of a position that has none.
inline constexpr double no_height = std::numeric_limits<double>::quiet_NaN();

/// The path through `positions`; its heights are kept when every position has one.
Path make_path(std::span<const Vec3d> positions);
/// The same for a ring of a format that repeats the first vertex at the end: the repetition is dropped, or its absence
/// noted.
Path make_closed_ring(std::span<const Vec3d> positions);

void append(Path& path, Path&& more);
/// Adds the geometry of `more`.
void append(Feature& feature, Feature&& more);

}  // namespace lambert::polygon
