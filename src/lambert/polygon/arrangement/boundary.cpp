#include "lambert/polygon/arrangement/boundary.h"

#include "lambert/polygon/arrangement/loop.h"
#include "lambert/polygon/arrangement/walk.h"
#include "lambert/polygon/predicates/predicates.h"

#include <algorithm>
#include <utility>

namespace lambert::polygon::arrangement {
namespace {

struct Loops {
  std::vector<Loop> loops;
  std::vector<std::uint32_t> walk_of_arc;
  std::uint32_t walks = 0;
};

/// Follows every walk and cuts off a ring whenever it comes to a node that it has left already.
Loops loops_of(const Boundary& boundary) {
  const std::vector<std::uint32_t> next = next_arcs(boundary);
  Loops result;
  result.walk_of_arc.assign(next.size(), none);
  std::vector<std::uint32_t> depth(boundary.nodes.size(), none), path;
  Ring scratch;
  for (std::uint32_t start = 0; start < next.size(); ++start) {
    if (result.walk_of_arc[start] != none) continue;
    const std::uint32_t walk = result.walks++;
    for (std::uint32_t arc = start; result.walk_of_arc[arc] == none; arc = next[arc]) {
      result.walk_of_arc[arc] = walk;
      depth[boundary.arcs[arc].from] = static_cast<std::uint32_t>(path.size());
      path.push_back(arc);
      const std::uint32_t cut = depth[boundary.arcs[arc].to];
      if (cut == none) continue;
      const std::span<const std::uint32_t> arcs = std::span(path).subspan(cut);
      Loop loop = loop_of(boundary, arcs, scratch);
      loop.walk = walk;
      result.loops.push_back(std::move(loop));
      for (const std::uint32_t i : arcs) depth[boundary.arcs[i].from] = none;
      path.resize(cut);
    }
  }
  return result;
}

/// Rings that start at one point differ in the next.
bool ring_before(const Ring& a, const Ring& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](Vec2d p, Vec2d q) { return compare_xy(p, q) < 0; });
}

/// Of two holes of one walk, which of them has the lowest arc at the smallest vertex of all. Clockwise rings arrive
/// there from below, so that is the last edge of the ring.
bool lower_start(const Ring& a, const Ring& b) {
  const int order = compare_xy(a.front(), b.front());
  return order != 0 ? order < 0 : orientation(a.front(), a.back(), b.back()) > 0;
}

}  // namespace

Regions regions_of(const Boundary& boundary, const ArcBelow& arc_below) {
  Loops all = loops_of(boundary);
  std::vector<std::uint32_t> region_of_walk(all.walks, none), first_hole(all.walks, none), floating;
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < all.loops.size(); ++i) {
    const Loop& loop = all.loops[i];
    std::uint32_t& hole = first_hole[loop.walk];
    if (!loop.is_hole) {
      region_of_walk[loop.walk] = count++;
    } else if (hole == none || lower_start(loop.ring, all.loops[hole].ring)) {
      hole = i;
    }
  }
  // Walks of holes alone hang in the region above what lies below them; that is further left, so it is known by then.
  for (std::uint32_t walk = 0; walk < all.walks; ++walk) {
    if (region_of_walk[walk] == none) floating.push_back(first_hole[walk]);
  }
  std::sort(floating.begin(), floating.end(), [&](std::uint32_t i, std::uint32_t j) {
    return compare_xy(all.loops[i].ring.front(), all.loops[j].ring.front()) < 0;
  });
  for (const std::uint32_t i : floating) {
    const Loop& loop = all.loops[i];
    region_of_walk[loop.walk] = region_of_walk[all.walk_of_arc[arc_below(loop.ring.front(), loop.arc)]];
  }

  Regions regions(count);
  for (Loop& loop : all.loops) {
    Region& region = regions[region_of_walk[loop.walk]];
    if (loop.is_hole) {
      region.holes.push_back(std::move(loop.ring));
    } else {
      region.outer = std::move(loop.ring);
    }
  }
  for (Region& region : regions) std::sort(region.holes.begin(), region.holes.end(), ring_before);
  std::sort(regions.begin(), regions.end(),
            [](const Region& a, const Region& b) { return ring_before(a.outer, b.outer); });
  return regions;
}

}  // namespace lambert::polygon::arrangement
