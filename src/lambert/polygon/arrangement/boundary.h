#pragma once
/// From the edges that bound a set to its regions.

#include "lambert/polygon/ring.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace lambert::polygon::arrangement {

/// A way from node to node with the set on its left; between its ends it meets no other arc. Nodes are equal exactly
/// when their points are.
struct Arc {
  std::uint32_t from, to;
  std::uint32_t begin = 0, end = 0;  ///< its points between, in Boundary::points
  bool backwards = false;            ///< they run from end to begin
};

struct Boundary {
  std::vector<Vec2d> nodes;
  std::vector<Arc> arcs;
  std::span<const Vec2d> points;
};

/// The arc directly below a vertex v, the lexicographically smallest of its connected part of the boundary: one with
/// the set above it. `arc` arrives at v and is the lowest that ends or starts there.
using ArcBelow = std::function<std::uint32_t(Vec2d v, std::uint32_t arc)>;

/// The regions, as boolean.h describes them. At every node as many arcs must arrive as leave, and around it they must
/// alternate.
Regions regions_of(const Boundary& boundary, const ArcBelow& arc_below);

}  // namespace lambert::polygon::arrangement
