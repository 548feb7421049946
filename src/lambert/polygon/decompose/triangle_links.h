#pragma once
#include "lambert/polygon/decompose/no_index.h"
#include "lambert/polygon/decompose/triangle.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lambert::polygon {

/// Side s of a triangle joins its corner s to corner (s + 1) % 3; it is numbered 3 triangle + s. For each side the
/// number of the side that runs the other way between the same corners, or no_index. Where several could pair, as no
/// tiling has it, each is paired at most once. O(n) for corners with few triangles each, O(n log n) otherwise.
std::vector<std::uint32_t> opposite_sides(std::span<const Triangle> triangles, std::size_t vertex_count);

}  // namespace lambert::polygon
