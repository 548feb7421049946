#pragma once
/// Triangles and quads as lists of vertex numbers (PG-36, PG-37). n triangles need 3 n numbers one by one and n + 2 in
/// a strip or fan; n quads 4 n and 2 n + 2. All orientations are kept. Decoding leaves out numbers at the end that make
/// no whole piece, and drops nothing else.

#include "lambert/polygon/decompose/triangle.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lambert::polygon {

using Indices = std::vector<std::uint32_t>;
using Quad = std::array<std::uint32_t, 4>;

/// 0 1 2, 3 4 5, ...
std::vector<Triangle> triangles_of_list(std::span<const std::uint32_t> list);
/// 0 1 2, 2 1 3, 2 3 4, 4 3 5, ...: every second one is reversed to keep the orientation of the first.
std::vector<Triangle> triangles_of_strip(std::span<const std::uint32_t> strip);
/// 0 1 2, 0 2 3, ...
std::vector<Triangle> triangles_of_fan(std::span<const std::uint32_t> fan);
/// 0 1 2 3, 4 5 6 7, ...
std::vector<Quad> quads_of_list(std::span<const std::uint32_t> list);
/// 0 1 3 2, 2 3 5 4, ...: each new pair makes three edges with the pair before.
std::vector<Quad> quads_of_strip(std::span<const std::uint32_t> strip);

Indices list_of(std::span<const Triangle> triangles);
Indices list_of(std::span<const Quad> quads);
/// The strip or fan that decodes to these triangles or quads in this order, each up to which corner comes first;
/// nothing when there is none.
std::optional<Indices> strip_of(std::span<const Triangle> triangles);
std::optional<Indices> fan_of(std::span<const Triangle> triangles);
std::optional<Indices> strip_of(std::span<const Quad> quads);

struct Strips {
  std::vector<Indices> strips;
  /// Numbers in all strips together, against 3 for each triangle one by one.
  std::size_t vertex_count() const;
};

/// Covers a mesh with strips: every triangle comes once, with its orientation. Each strip begins at a triangle with few
/// free neighbours and takes the longest of its three ways (the heuristic of SGI's tomesh); strips do not turn twice
/// the same way. Triangles are neighbours when they share two corners in opposite order. O(n).
Strips cover_with_strips(std::span<const Triangle> triangles);

}  // namespace lambert::polygon
