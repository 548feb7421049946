#include "lambert/polygon/edge_list.h"

namespace lambert::polygon {

EdgeList::EdgeList(const Rings& rings, double scale) {
  for (const Ring& ring : rings) {
    for (const Vec2d p : ring) {
      numbers.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p * scale);
    }
    if (!ring.empty()) points.push_back(ring.front() * scale);
  }
}

// An edge is crossed when its ends lie on different sides of the line to p, and both points on different sides of it.
// An end on the line counts as one to its right: as if the line were moved a little to the left, where it meets no end.
Winding EdgeList::winding_from(Vec2d reference, int winding, Vec2d p, std::span<const std::uint32_t> candidates) const {
  for (const std::uint32_t edge : candidates) {
    const Vec2d a = points[edge], b = points[edge + 1];
    const int side = orientation(a, b, p);
    if (side == 0) {
      if (between(a, b, p)) return {0, true};
      continue;
    }
    if ((orientation(reference, p, a) > 0) == (orientation(reference, p, b) > 0)) continue;
    if (orientation(a, b, reference) != side) winding += side;
  }
  return {winding, false};
}

}  // namespace lambert::polygon
