#include "lambert/polygon/arrangement/subdivision.h"

#include "lambert/polygon/arrangement/sweep.h"

#include <cmath>

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

}  // namespace

Subdivision subdivide(const Outline& outline) {
  Subdivision result{pieces_of(outline)};
  for (;; ++result.rounds) {
    const double tolerance = result.rounds < free_rounds ? 0 : std::ldexp(1.0, result.rounds - free_rounds - 51);
    Sweep sweep(outline, tolerance, result.pieces);
    if (sweep.run()) {
      result.nodes = sweep.node_count();
      return result;
    }
    for (Piece& piece : result.pieces) piece = {piece.a, piece.b, piece.line, piece.delta, {}};
  }
}

}  // namespace lambert::polygon::arrangement
