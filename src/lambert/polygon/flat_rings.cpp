#include "lambert/polygon/flat_rings.h"

namespace lambert::polygon {
namespace {

void append(const Ring& ring, FlatRings& all) {
  all.vertices.insert(all.vertices.end(), ring.begin(), ring.end());
  all.ends.push_back(static_cast<std::uint32_t>(all.vertices.size()));
}

}  // namespace

FlatRings flat(const Rings& rings) {
  FlatRings all;
  for (const Ring& ring : rings) append(ring, all);
  return all;
}

FlatRings flat(const Region& region) {
  FlatRings all;
  append(region.outer, all);
  for (const Ring& hole : region.holes) append(hole, all);
  return all;
}

FlatRings scaled(FlatRings rings, double factor) {
  for (Vec2d& p : rings.vertices) p *= factor;
  return rings;
}

std::vector<std::uint32_t> successors(const FlatRings& rings) {
  std::vector<std::uint32_t> next(rings.vertices.size());
  std::uint32_t begin = 0;
  for (const std::uint32_t end : rings.ends) {
    for (std::uint32_t i = begin; i < end; ++i) next[i] = i + 1 == end ? begin : i + 1;
    begin = end;
  }
  return next;
}

}  // namespace lambert::polygon
