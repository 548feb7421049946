#include "lambert/polygon/accurate.h"

#include "lambert/polygon/expansion.h"

namespace lambert::polygon {

double accurate_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x), difference = left - right;
  // The three roundings of each product make at most 3.1 units of it, the last one half a unit of the difference.
  if (std::abs(difference) >= 0x1p-2 * (std::abs(left) + std::abs(right))) return difference;
  const auto exact = [](double p, double q) { return Expansion<2>(two_sum(p, -q)); };
  return (exact(b.x, a.x) * exact(d.y, c.y) - exact(b.y, a.y) * exact(d.x, c.x)).estimate();
}

}  // namespace lambert::polygon
