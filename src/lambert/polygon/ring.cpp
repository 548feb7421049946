#include "lambert/polygon/ring.h"

namespace lambert::polygon {

Rings rings_of(const Region& region) {
  Rings rings{region.outer};
  rings.insert(rings.end(), region.holes.begin(), region.holes.end());
  return rings;
}

Rings rings_of(const Regions& regions) {
  Rings rings;
  for (const Region& region : regions) {
    rings.push_back(region.outer);
    rings.insert(rings.end(), region.holes.begin(), region.holes.end());
  }
  return rings;
}

double signed_area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Vec2d a = ring[i - 1] - ring[0], b = ring[i] - ring[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

double signed_area(const Rings& rings) {
  double sum = 0;
  for (const Ring& ring : rings) sum += signed_area(ring);
  return sum;
}

double area(const Region& region) { return signed_area(region.outer) + signed_area(region.holes); }

double area(const Regions& regions) {
  double sum = 0;
  for (const Region& region : regions) sum += area(region);
  return sum;
}

}  // namespace lambert::polygon
