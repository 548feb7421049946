#include "lambert/polygon/ring.h"

#include "lambert/polygon/scale.h"

namespace lambert::polygon {
namespace {

double twice_signed_area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Vec2d a = ring[i - 1] - ring[0], b = ring[i] - ring[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice;
}

/// Neither did a product overflow nor do those count that vanished.
bool is_safe(double sum) { return std::isfinite(sum) && std::abs(sum) >= 0x1p-900; }

}  // namespace

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
  const double twice = twice_signed_area(ring);
  if (is_safe(twice)) return 0.5 * twice;
  return static_cast<double>(wide_signed_area(ring));
}

long double wide_signed_area(const Ring& ring) {
  if (const double twice = twice_signed_area(ring); is_safe(twice)) return 0.5L * static_cast<long double>(twice);
  const double scale = unit_scale(0.5 * sizes_of(ring).most);
  const auto twice = static_cast<long double>(twice_signed_area(scaled(ring, scale)));
  return 0.5L * twice / static_cast<long double>(scale) / static_cast<long double>(scale);
}

double perimeter(const Rings& rings) {
  double sum = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) sum += safe_length(ring[next_index(i, ring.size())] - ring[i]);
  return sum;
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
