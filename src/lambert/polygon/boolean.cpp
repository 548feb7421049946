#include "lambert/polygon/boolean.h"

#include "lambert/polygon/arrangement/boundary.h"
#include "lambert/polygon/arrangement/subdivision.h"
#include "lambert/polygon/predicates.h"

#include <algorithm>
#include <utility>

namespace lambert::polygon {
namespace {

using namespace arrangement;

/// The pieces that have the set on one side only.
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

Regions run(const Rings& subject, const Rings& clip, const Selection& selection) {
  const Outline outline = outline_of(subject, clip);
  Regions regions = select(subdivide(outline), selection);
  unscale(outline, regions);
  return regions;
}

/// Lexicographic, to put operands into an order that does not depend on which is called what.
bool before(const Rings& a, const Rings& b) {
  const auto ring_before = [](const Ring& r, const Ring& s) {
    return std::lexicographical_compare(r.begin(), r.end(), s.begin(), s.end(),
                                        [](Vec2d p, Vec2d q) { return compare_xy(p, q) < 0; });
  };
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), ring_before);
}

}  // namespace

Regions boolean(BooleanOp op, const Rings& subject, const Rings& clip, FillRule rule) {
  const bool exchange = op != BooleanOp::subtract && before(clip, subject);
  return exchange ? run(clip, subject, {op, rule}) : run(subject, clip, {op, rule});
}

Regions normalised(const Rings& rings, FillRule rule) { return run(rings, {}, {BooleanOp::unite, rule}); }

}  // namespace lambert::polygon
