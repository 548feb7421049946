#pragma once
#include "lambert/polygon/point_in_polygon.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambert::polygon {

/// The edges of rings under one number each: number s stands for the edge from points[s] to points[s + 1].
struct EdgeList {
  explicit EdgeList(const Rings& rings, double scale = 1);

  std::vector<Vec2d> points;           ///< each ring with its first vertex repeated, times the scale
  std::vector<std::uint32_t> numbers;  ///< of all edges

  /// The winding number at p by the one at `reference`, which lies on no edge: `candidates` must name, once each, all
  /// edges that meet the segment between the two. Exact.
  Winding winding_from(Vec2d reference, int winding, Vec2d p, std::span<const std::uint32_t> candidates) const;
};

}  // namespace lambert::polygon
