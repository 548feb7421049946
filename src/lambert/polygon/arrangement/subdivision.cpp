#include "lambert/polygon/arrangement/subdivision.h"

#include "lambert/polygon/arrangement/boundary.h"
#include "lambert/polygon/arrangement/sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::polygon::arrangement {
namespace {

/// Rounds without a tolerance, which all but inputs with edges within some units in the last place of each other end
/// in.
constexpr int free_rounds = 3;

std::vector<Piece> pieces_of(const Outline& outline) {
  std::vector<Piece> pieces;
  pieces.reserve(outline.points.size());
  for (std::size_t ring = 0; ring < outline.ring_count(); ++ring) {
    for (std::uint32_t i = outline.starts[ring]; i + 1 < outline.starts[ring + 1]; ++i) {
      const Vec2d a = outline.points[i], b = outline.points[i + 1];
      // Left of an edge the winding is one more than right of it; above is left of what runs to the right.
      const Winding left = outline.winding_of(i);
      pieces.push_back(compare_xy(a, b) < 0 ? Piece{a, b, i, left, {}} : Piece{b, a, i, -left, {}});
    }
  }
  return pieces;
}

/// Rounds without a grid for all points.
constexpr int floating_rounds = 12;

void snap(std::vector<Piece>& pieces, const Grid& grid) {
  for (Piece& piece : pieces) {
    piece.a = grid(piece.a);
    piece.b = grid(piece.b);
    if (compare_xy(piece.a, piece.b) > 0) {
      std::swap(piece.a, piece.b);
      piece.delta = -piece.delta;
    }
  }
  std::erase_if(pieces, [](const Piece& piece) { return piece.a == piece.b; });
}

double largest_coordinate(const Outline& outline) {
  double largest = 0;
  for (const Vec2d p : outline.points) largest = std::max(largest, std::max(std::abs(p.x), std::abs(p.y)));
  return largest;
}

}  // namespace

Subdivision subdivide(const Outline& outline) {
  Subdivision result{pieces_of(outline)};
  Grid grid = outline.grid;
  Sweep sweep(outline, result.pieces);
  for (;; ++result.rounds) {
    const double tolerance =
        result.rounds < free_rounds ? 0 : std::min(std::ldexp(1.0, result.rounds - free_rounds - 51), 0x1p-40);
    if (result.rounds >= floating_rounds) {
      const double quantum = std::ldexp(largest_coordinate(outline), result.rounds - floating_rounds - 46);
      grid = Grid(std::exp2(std::floor(std::log2(quantum))));
      snap(result.pieces, grid);
    }
    if (sweep.run(grid, tolerance)) {
      result.nodes = sweep.node_count();
      return result;
    }
  }
}

Regions select(const Subdivision& subdivision, const Selection& selection) {
  Boundary boundary;
  boundary.nodes.resize(subdivision.nodes);
  std::vector<std::uint32_t> arc_of(subdivision.pieces.size(), none), piece_of;
  for (std::uint32_t i = 0; i < subdivision.pieces.size(); ++i) {
    const Piece& piece = subdivision.pieces[i];
    const bool below = selection.contains(piece.below), above = selection.contains(piece.below + piece.delta);
    if (below == above) continue;
    boundary.nodes[piece.from] = piece.a;
    boundary.nodes[piece.to] = piece.b;
    arc_of[i] = static_cast<std::uint32_t>(boundary.arcs.size());
    boundary.arcs.push_back(above ? Arc{piece.from, piece.to} : Arc{piece.to, piece.from});
    piece_of.push_back(i);
  }

  // The next boundary piece below: the places above and below a piece that is none belong to the same part of the set,
  // so the piece below it serves as well, and is remembered.
  std::vector<std::uint32_t> support(subdivision.pieces.size());
  for (std::uint32_t i = 0; i < support.size(); ++i) support[i] = subdivision.pieces[i].support;
  const auto arc_below = [&](Vec2d, std::uint32_t arc) {
    const std::uint32_t start = piece_of[arc];
    std::uint32_t found = support[start];
    while (arc_of[found] == none) found = support[found];
    for (std::uint32_t i = start; i != found;) i = std::exchange(support[i], found);
    return arc_of[found];
  };
  return regions_of(boundary, arc_below);
}

}  // namespace lambert::polygon::arrangement
