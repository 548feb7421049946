#include "lambert/polygon/predicates.h"

#include "lambert/polygon/exact_cross.h"

namespace lambert::polygon {

int exact::orientation(Vec2d a, Vec2d b, Vec2d c) {
  if (!products_fit<2>({a, b, c})) return exact_cross<WideReal>(c, a, c, b).sign();
  const RoundedSum ax = two_sum(a.x, -c.x), by = two_sum(b.y, -c.y), ay = two_sum(a.y, -c.y), bx = two_sum(b.x, -c.x);
  if (ax.error == 0 && by.error == 0 && ay.error == 0 && bx.error == 0) {
    // Rounding keeps the order of the products, so their errors count only where the rounded ones are equal.
    const RoundedSum one = two_product(ax.value, by.value), other = two_product(ay.value, bx.value);
    if (one.value != other.value) return one.value > other.value ? 1 : -1;
    return one.error > other.error ? 1 : (one.error < other.error ? -1 : 0);
  }
  return exact_cross<double>(c, a, c, b).sign();
}

int in_circle(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  {
    // Products below 2^-1022 are off by up to 2^-1075 besides; the last two terms outweigh what that makes of the rest.
    constexpr double unit = 0x1p-53, bound = (10 + 96 * unit) * unit;
    const Vec2d p = a - d, q = b - d, r = c - d;
    const double qr = q.x * r.y, rq = r.x * q.y, rp = r.x * p.y, pr = p.x * r.y, pq = p.x * q.y, qp = q.x * p.y;
    const double pp = dot(p, p), qq = dot(q, q), rr = dot(r, r);
    const double determinant = pp * (qr - rq) + qq * (rp - pr) + rr * (pq - qp);
    const double limit = bound * (pp * (std::abs(qr) + std::abs(rq)) + qq * (std::abs(rp) + std::abs(pr)) +
                                  rr * (std::abs(pq) + std::abs(qp))) +
                         0x1p-1069 * (pp + qq + rr) + 0x1p-1069;
    if (determinant > limit) return 1;
    if (-determinant > limit) return -1;
  }
  return decide_exactly<4>({a, b, c, d}, [&](auto zero) {
    using Real = decltype(zero);
    const auto px = exact_difference<Real>(a.x, d.x), py = exact_difference<Real>(a.y, d.y);
    const auto qx = exact_difference<Real>(b.x, d.x), qy = exact_difference<Real>(b.y, d.y);
    const auto rx = exact_difference<Real>(c.x, d.x), ry = exact_difference<Real>(c.y, d.y);
    const auto first = (px * px + py * py) * (qx * ry - rx * qy);
    const auto second = (qx * qx + qy * qy) * (rx * py - px * ry);
    const auto third = (rx * rx + ry * ry) * (px * qy - qx * py);
    return (first + second + third).sign();
  });
}

int dot_sign(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  constexpr double unit = 0x1p-53, bound = (3 + 16 * unit) * unit;
  const double x = (b.x - a.x) * (d.x - c.x), y = (b.y - a.y) * (d.y - c.y),
               limit = bound * (std::abs(x) + std::abs(y)) + 0x1p-1072;
  if (x + y > limit) return 1;
  if (-(x + y) > limit) return -1;
  return decide_exactly<2>({a, b, c, d}, [&](auto zero) {
    using Real = decltype(zero);
    return (exact_difference<Real>(b.x, a.x) * exact_difference<Real>(d.x, c.x) +
            exact_difference<Real>(b.y, a.y) * exact_difference<Real>(d.y, c.y))
        .sign();
  });
}

int turn_sign(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  constexpr double unit = 0x1p-53, bound = (3 + 16 * unit) * unit;
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  const double limit = bound * (std::abs(left) + std::abs(right)) + 0x1p-1072;
  if (left - right > limit) return 1;
  if (right - left > limit) return -1;
  return decide_exactly<2>({a, b, c, d}, [&](auto zero) { return exact_cross<decltype(zero)>(a, b, c, d).sign(); });
}

}  // namespace lambert::polygon
