#pragma once
#include "lambert/base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambert::polygon {

/// The indices of the points from left to right, from below to above where x is the same (compare_xy), by index where
/// both are. One bucket a point: near linear for points that are spread out, n log n at worst.
std::vector<std::uint32_t> sorted_left_to_right(std::span<const Vec2d> points);

}  // namespace lambert::polygon
