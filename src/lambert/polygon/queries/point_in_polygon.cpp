#include "lambert/polygon/queries/point_in_polygon.h"

namespace lambert::polygon {
namespace {

/// Adds the edges that a ray from p to the left crosses: +1 for those that run down, which have p on their left side,
/// and -1 for those that run up.
void add_winding(const Ring& ring, Vec2d p, Winding& winding) {
  Vec2d a = ring.empty() ? Vec2d(0) : ring.back();
  for (const Vec2d b : ring) {
    const bool a_above = a.y > p.y, b_above = b.y > p.y;
    if (a_above != b_above) {
      const int side = orientation(a, b, p);
      if (side == 0) winding.on = true;
      if (side < 0 && b_above) --winding.number;
      if (side > 0 && a_above) ++winding.number;
    } else if ((a.y == p.y || b.y == p.y) && on_segment(a, b, p)) {
      winding.on = true;
    }
    a = b;
  }
}

Place place_of(const Winding& winding, FillRule rule) {
  if (winding.on) return Place::on;
  return is_inside(winding.number, rule) ? Place::inside : Place::outside;
}

}  // namespace

Winding winding_around(const Rings& rings, Vec2d p) {
  Winding winding;
  for (const Ring& ring : rings) add_winding(ring, p, winding);
  return winding;
}

Winding winding_around(const Ring& ring, Vec2d p) {
  Winding winding;
  add_winding(ring, p, winding);
  return winding;
}

Place locate(const Rings& rings, Vec2d p, FillRule rule) { return place_of(winding_around(rings, p), rule); }
Place locate(const Ring& ring, Vec2d p, FillRule rule) { return place_of(winding_around(ring, p), rule); }

std::size_t strips_around(const Ring& ring, Vec2d p) {
  std::size_t strips = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Vec2d low = ring[i], high = ring[next_index(i, ring.size())];
    if (low.y > high.y) std::swap(low, high);
    strips += p.y > low.y && p.y <= high.y && orientation(low, high, p) < 0;
  }
  return strips;
}

}  // namespace lambert::polygon
