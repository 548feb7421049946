#include "lambert/polygon/boolean/boolean.h"

#include "lambert/polygon/arrangement/network.h"
#include "lambert/polygon/arrangement/subdivision.h"
#include "lambert/polygon/predicates/predicates.h"

#include <algorithm>

namespace lambert::polygon {
namespace {

using namespace arrangement;

Regions run(const Rings& subject, const Rings& clip, const Selection& selection) {
  const Outline outline = outline_of(subject, clip);
  if (outline.points.empty()) return {};
  const BoxTree tree(outline);
  const auto marks = find_marks(outline, tree);
  Regions regions = marks ? Network(outline, tree, *marks).select(selection) : select(subdivide(outline), selection);
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
