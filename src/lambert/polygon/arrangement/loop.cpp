#include "lambert/polygon/arrangement/loop.h"

#include "lambert/polygon/predicates/predicates.h"

#include <algorithm>

namespace lambert::polygon::arrangement {

Loop loop_of(const Boundary& boundary, std::span<const std::uint32_t> arcs, Ring& scratch) {
  scratch.clear();
  std::size_t expected = 0;
  for (const std::uint32_t i : arcs) expected += 1 + boundary.arcs[i].end - boundary.arcs[i].begin;
  scratch.reserve(expected);
  const Vec2d* const points = boundary.points.data();
  for (const std::uint32_t i : arcs) {
    const Arc& arc = boundary.arcs[i];
    scratch.push_back(boundary.nodes[arc.from]);
    if (arc.backwards) {
      scratch.insert(scratch.end(), std::make_reverse_iterator(points + arc.end),
                     std::make_reverse_iterator(points + arc.begin));
    } else {
      scratch.insert(scratch.end(), points + arc.begin, points + arc.end);
    }
  }
  const std::size_t size = scratch.size();
  const Vec2d* const p = scratch.data();
  std::size_t smallest = 0;
  for (std::size_t i = 1; i < size; ++i) {
    if (p[i].x < p[smallest].x || (p[i].x == p[smallest].x && p[i].y < p[smallest].y)) smallest = i;
  }

  Loop loop;
  loop.ring.reserve(size);
  Vec2d before = p[previous_index(smallest, size)];
  loop.is_hole = orientation(before, p[smallest], p[next_index(smallest, size)]) < 0;
  const auto append = [&](std::size_t begin, std::size_t end, Vec2d beyond) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2d after = i + 1 < end ? p[i + 1] : beyond;
      if (orientation(before, p[i], after) != 0) loop.ring.push_back(p[i]);
      before = p[i];
    }
  };
  append(smallest, size, p[0]);
  append(0, smallest, p[smallest]);

  std::size_t passed = 0;  // points before arc i
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Arc& arc = boundary.arcs[arcs[i]];
    if (passed == smallest) {
      loop.arc = arcs[previous_index(i, arcs.size())];
      break;
    }
    passed += 1 + arc.end - arc.begin;
    if (passed > smallest) {
      loop.arc = arcs[i];
      break;
    }
  }
  return loop;
}

}  // namespace lambert::polygon::arrangement
