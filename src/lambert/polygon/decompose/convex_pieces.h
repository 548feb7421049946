#pragma once
#include "lambert/polygon/decompose/flat_rings.h"
#include "lambert/polygon/decompose/triangle.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambert::polygon {

/// Joins triangles that tile a region, across every side whose removal leaves no reflex corner (Hertel and Mehlhorn
/// 1983): convex pieces, counter-clockwise, at most four times as few as any others of these rings could be, and at
/// most one more than twice the number of reflex vertices when there is no hole. Corners of 180 degrees stay. Decided
/// exactly; O(n).
std::vector<std::vector<std::uint32_t>> joined_to_convex(std::span<const Vec2d> vertices,
                                                         std::span<const Triangle> triangles);

enum class ConvexMethod : std::uint8_t {
  joined_triangles,  ///< of delaunay(): few pieces with the region's own vertices
  trapezoids,        ///< of trapezoids(): 3 or 4 corners each, some of them new; O(n^2) pieces
};

/// Convex pieces that tile a region whose rings do not cross (PG-21: not the fewest possible).
std::vector<Ring> convex_pieces(const Region& region, ConvexMethod method = ConvexMethod::joined_triangles);

}  // namespace lambert::polygon
