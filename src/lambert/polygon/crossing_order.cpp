#include "lambert/polygon/crossing_order.h"

#include "lambert/polygon/expansion.h"

namespace lambert::polygon {
namespace {

using Difference = Expansion<2>;
using Cross = Expansion<16>;

Difference difference(double a, double b) { return Difference(two_sum(a, -b)); }

Cross exact_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  return difference(b.x, a.x) * difference(d.y, c.y) - difference(b.y, a.y) * difference(d.x, c.x);
}

struct RoundedCross {
  double value, size;  ///< the sum of the sizes of both products
};

RoundedCross rounded_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  return {left - right, std::abs(left) + std::abs(right)};
}

}  // namespace

// The crossing is a + (n / m) (b - a) with n = (c - a) x (d - c) and m = (b - a) x (d - c); along each axis its
// difference from p is ((a - p) m + n (b - a)) / m.
int compare_crossing(Vec2d a, Vec2d b, Vec2d c, Vec2d d, Vec2d p) {
  const RoundedCross n = rounded_cross(a, c, c, d), m = rounded_cross(a, b, c, d);
  // n and m are off by at most 4.1 units of their sizes, their products with a rounded difference by 6.2, the sum by
  // one more of it.
  constexpr double bound = 8 * 0x1p-53;
  if (std::abs(m.value) > bound * m.size) {
    const int sign = m.value > 0 ? 1 : -1;
    const double first = (a.x - p.x) * m.value, second = n.value * (b.x - a.x);
    const double limit = bound * (std::abs(a.x - p.x) * m.size + n.size * std::abs(b.x - a.x));
    if (first + second > limit) return sign;
    if (-(first + second) > limit) return -sign;
  }
  const Cross exact_n = exact_cross(a, c, c, d), exact_m = exact_cross(a, b, c, d);
  if (const int x = (difference(a.x, p.x) * exact_m + difference(b.x, a.x) * exact_n).sign()) return x * exact_m.sign();
  return (difference(a.y, p.y) * exact_m + difference(b.y, a.y) * exact_n).sign() * exact_m.sign();
}

}  // namespace lambert::polygon
