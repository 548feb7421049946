#pragma once
/// A proper subdivision of the plane: pieces of edges that meet in their ends only.

#include "lambert/polygon/arrangement/outline.h"
#include "lambert/polygon/arrangement/status.h"

#include <vector>

namespace lambert::polygon::arrangement {

struct Piece {
  Vec2d a, b;                    ///< a is lexicographically smaller
  std::uint32_t line;            ///< the edge of the outline whose part it is
  Winding delta;                 ///< winding above less winding below; zero when it has merged into another piece
  Winding below;                 ///< winding just below
  std::uint32_t support = none;  ///< the piece directly below a
  std::uint32_t from = none, to = none;  ///< nodes: equal for equal points
};

struct Subdivision {
  std::vector<Piece> pieces;
  std::uint32_t nodes = 0;
  int rounds = 0;
};

/// By a plane sweep, repeated until it finds nothing to split: O((n + k) log n) expected for each round (boolean.h says
/// how rounds end). The crossings are found as by Bentley and Ottmann (1979), but edges are cut at the rounded point at
/// once (Martinez, Rueda and Feito, 2009), so that no comparison of crossing points is needed; that the last sweep
/// found only neighbours that do not meet proves the result.
Subdivision subdivide(const Outline& outline);

/// The regions of a set, in the scale of the outline: bounded by the pieces that have it on one side only.
Regions select(const Subdivision& subdivision, const Selection& selection);

}  // namespace lambert::polygon::arrangement
