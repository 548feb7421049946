#include "lambert/polygon/components.h"

#include "lambert/polygon/predicates.h"

#include <glm/common.hpp>

#include <algorithm>
#include <optional>

namespace lambert::polygon {
namespace {

struct Box {
  Vec2d min, max;
  bool contains(const Box& b) const {
    return min.x <= b.min.x && min.y <= b.min.y && b.max.x <= max.x && b.max.y <= max.y;
  }
};

Box box_of(const Ring& ring) {
  Box box{ring[0], ring[0]};
  for (const Vec2d p : ring) box = {glm::min(box.min, p), glm::max(box.max, p)};
  return box;
}

/// Whether the edge from p to q, where p lies on the outer ring between or on its vertices a, b, c (a straight piece
/// has p between a and b and no c), begins inside; nothing when it begins along the ring.
std::optional<bool> begins_inside(Vec2d a, Vec2d p, Vec2d c, Vec2d q) {
  const int before = orientation(a, p, q), after = orientation(p, c, q);
  const int corner = orientation(a, p, c);
  const auto ahead = [&](Vec2d end) { return dot_sign(p, end, p, q) > 0; };
  if ((before == 0 && ahead(a)) || (after == 0 && ahead(c))) return std::nullopt;
  if (corner > 0) return before > 0 && after > 0;
  if (corner < 0) return before > 0 || after > 0;
  return before > 0;
}

/// Where p lies: -1 outside, 1 inside, 0 on the ring.
int place(const Ring& ring, Vec2d p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
    if (on_segment(a, b, p)) return 0;
    if ((a.y <= p.y) != (b.y <= p.y)) inside ^= orientation(a, b, p) == (b.y > a.y ? 1 : -1);
  }
  return inside ? 1 : -1;
}

bool contains(const Ring& outer, const Ring& hole) {
  for (const Vec2d p : hole)
    if (const int where = place(outer, p); where != 0) return where > 0;
  // All vertices lie on the outer ring: an edge that does not run along it decides.
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const Vec2d p = hole[i], q = hole[next_index(i, hole.size())];
    for (std::size_t k = 0; k < outer.size(); ++k) {
      const Vec2d a = outer[k], b = outer[next_index(k, outer.size())];
      if (p == q || a == b || p == b || !on_segment(a, b, p)) continue;
      std::size_t before = k;
      if (p == a) do
          before = previous_index(before, outer.size());
        while (outer[before] == p && before != k);
      const auto inside = begins_inside(p == a ? outer[before] : a, p, b, q);
      if (inside) return *inside;
    }
  }
  return false;
}

}  // namespace

Regions components(const Rings& rings) {
  struct Piece {
    Region region;
    Box box;
    long double area;
  };
  std::vector<Piece> pieces;
  for (const Ring& ring : rings)
    if (const long double area = wide_signed_area(ring); area > 0) pieces.push_back({{ring, {}}, box_of(ring), area});
  std::vector<Piece*> by_area;
  for (Piece& piece : pieces) by_area.push_back(&piece);
  std::stable_sort(by_area.begin(), by_area.end(), [](const Piece* a, const Piece* b) { return a->area < b->area; });

  for (const Ring& ring : rings) {
    if (!(wide_signed_area(ring) < 0)) continue;
    const Box box = box_of(ring);
    const auto around = std::find_if(by_area.begin(), by_area.end(), [&](const Piece* piece) {
      return piece->box.contains(box) && contains(piece->region.outer, ring);
    });
    if (around != by_area.end()) (*around)->region.holes.push_back(ring);
  }
  Regions regions;
  for (Piece& piece : pieces) regions.push_back(std::move(piece.region));
  return regions;
}

}  // namespace lambert::polygon
