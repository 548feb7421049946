#include "lambert/polygon/arrangement/walk.h"

#include "lambert/polygon/predicates/predicates.h"

#include <algorithm>
#include <cassert>

namespace lambert::polygon::arrangement {
namespace {

/// An end of an arc at a node.
struct Spoke {
  Vec2d towards;
  std::uint32_t arc;
  bool leaves;
};

Vec2d point_after_start(const Boundary& boundary, const Arc& arc) {
  if (arc.begin == arc.end) return boundary.nodes[arc.to];
  return boundary.points[arc.backwards ? arc.end - 1 : arc.begin];
}

Vec2d point_before_end(const Boundary& boundary, const Arc& arc) {
  if (arc.begin == arc.end) return boundary.nodes[arc.from];
  return boundary.points[arc.backwards ? arc.begin : arc.end - 1];
}

/// Counter-clockwise from straight down, which itself comes last.
bool earlier(Vec2d centre, Vec2d a, Vec2d b) {
  const bool a_left = compare_xy(a, centre) < 0, b_left = compare_xy(b, centre) < 0;
  if (a_left != b_left) return b_left;
  return orientation(centre, a, b) > 0;
}

}  // namespace

std::vector<std::uint32_t> next_arcs(const Boundary& boundary) {
  const std::size_t nodes = boundary.nodes.size();
  std::vector<std::uint32_t> first(nodes + 1, 0), leaving(boundary.arcs.size()), arriving(boundary.arcs.size());
  for (const Arc& arc : boundary.arcs) ++first[arc.from + 1];
  for (std::size_t i = 0; i < nodes; ++i) first[i + 1] += first[i];
  std::vector<std::uint32_t> fill_leaving = first, fill_arriving = first;  // as many arrive as leave
  for (std::uint32_t i = 0; i < boundary.arcs.size(); ++i) {
    leaving[fill_leaving[boundary.arcs[i].from]++] = i;
    arriving[fill_arriving[boundary.arcs[i].to]++] = i;
  }

  std::vector<std::uint32_t> next(boundary.arcs.size(), none);
  std::vector<Spoke> spokes;
  for (std::size_t node = 0; node < nodes; ++node) {
    const std::uint32_t begin = first[node], end = first[node + 1];
    if (end == begin) continue;
    if (end - begin == 1) {
      next[arriving[begin]] = leaving[begin];
      continue;
    }
    spokes.clear();
    for (std::uint32_t i = begin; i < end; ++i) {
      spokes.push_back({point_after_start(boundary, boundary.arcs[leaving[i]]), leaving[i], true});
      spokes.push_back({point_before_end(boundary, boundary.arcs[arriving[i]]), arriving[i], false});
    }
    const Vec2d centre = boundary.nodes[node];
    std::sort(spokes.begin(), spokes.end(),
              [&](const Spoke& a, const Spoke& b) { return earlier(centre, a.towards, b.towards); });
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      const Spoke& clockwise = spokes[(i + spokes.size() - 1) % spokes.size()];
      assert(spokes[i].leaves != clockwise.leaves);
      if (!spokes[i].leaves) next[spokes[i].arc] = clockwise.arc;
    }
  }
  return next;
}

}  // namespace lambert::polygon::arrangement
