#include "lambert/polygon/crossing_order.h"

#include "lambert/polygon/exact_cross.h"

namespace lambert::polygon {

// The crossing is a + (n / m) (b - a) with n = (c - a) x (d - c) and m = (b - a) x (d - c); along each axis its
// difference from p is ((a - p) m + n (b - a)) / m.
int compare_crossing(Vec2d a, Vec2d b, Vec2d c, Vec2d d, Vec2d p) {
  const RoundedCross n = rounded_cross(a, c, c, d), m = rounded_cross(a, b, c, d);
  // n and m are off by at most 4.1 units of their sizes, their products with a rounded difference by 6.2, the sum by
  // one more of it. The constants cover products below 2^-1022.
  constexpr double bound = 8 * 0x1p-53;
  if (std::abs(m.value) > bound * m.size + 0x1p-1072) {
    const int sign = m.value > 0 ? 1 : -1;
    const double first = (a.x - p.x) * m.value, second = n.value * (b.x - a.x);
    const double ap = std::abs(a.x - p.x), ab = std::abs(b.x - a.x);
    const double limit = bound * (ap * m.size + n.size * ab) + 0x1p-1070 * (ap + ab) + 0x1p-1070;
    if (first + second > limit) return sign;
    if (-(first + second) > limit) return -sign;
  }
  return decide_exactly<3>({a, b, c, d, p}, [&](auto zero) {
    using Real = decltype(zero);
    const auto exact_n = exact_cross<Real>(a, c, c, d), exact_m = exact_cross<Real>(a, b, c, d);
    const auto side = [&](int axis) {
      return (exact_difference<Real>(a[axis], p[axis]) * exact_m + exact_difference<Real>(b[axis], a[axis]) * exact_n)
          .sign();
    };
    const int x = side(0);
    return (x != 0 ? x : side(1)) * exact_m.sign();
  });
}

}  // namespace lambert::polygon
