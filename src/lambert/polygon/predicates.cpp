#include "lambert/polygon/predicates.h"

#include "lambert/polygon/expansion.h"

namespace lambert::polygon {
namespace {

using Difference = Expansion<2>;

Difference difference(double a, double b) { return Difference(two_sum(a, -b)); }

}  // namespace

int exact::orientation(Vec2d a, Vec2d b, Vec2d c) {
  const RoundedSum ax = two_sum(a.x, -c.x), by = two_sum(b.y, -c.y), ay = two_sum(a.y, -c.y), bx = two_sum(b.x, -c.x);
  if (ax.error == 0 && by.error == 0 && ay.error == 0 && bx.error == 0) {
    // Rounding keeps the order of the products, so their errors count only where the rounded ones are equal.
    const RoundedSum one = two_product(ax.value, by.value), other = two_product(ay.value, bx.value);
    if (one.value != other.value) return one.value > other.value ? 1 : -1;
    return one.error > other.error ? 1 : (one.error < other.error ? -1 : 0);
  }
  const auto left = difference(a.x, c.x) * difference(b.y, c.y);
  const auto right = difference(a.y, c.y) * difference(b.x, c.x);
  return (left - right).sign();
}

int in_circle(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  {
    constexpr double unit = 0x1p-53, bound = (10 + 96 * unit) * unit;
    const Vec2d p = a - d, q = b - d, r = c - d;
    const double qr = q.x * r.y, rq = r.x * q.y, rp = r.x * p.y, pr = p.x * r.y, pq = p.x * q.y, qp = q.x * p.y;
    const double pp = dot(p, p), qq = dot(q, q), rr = dot(r, r);
    const double determinant = pp * (qr - rq) + qq * (rp - pr) + rr * (pq - qp);
    const double limit = bound * (pp * (std::abs(qr) + std::abs(rq)) + qq * (std::abs(rp) + std::abs(pr)) +
                                  rr * (std::abs(pq) + std::abs(qp)));
    if (determinant > limit) return 1;
    if (-determinant > limit) return -1;
  }
  const Difference px = difference(a.x, d.x), py = difference(a.y, d.y), qx = difference(b.x, d.x),
                   qy = difference(b.y, d.y), rx = difference(c.x, d.x), ry = difference(c.y, d.y);
  const auto first = (px * px + py * py) * (qx * ry - rx * qy);
  const auto second = (qx * qx + qy * qy) * (rx * py - px * ry);
  const auto third = (rx * rx + ry * ry) * (px * qy - qx * py);
  return (first + second + third).sign();
}

int dot_sign(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  constexpr double unit = 0x1p-53, bound = (3 + 16 * unit) * unit;
  const double x = (b.x - a.x) * (d.x - c.x), y = (b.y - a.y) * (d.y - c.y),
               limit = bound * (std::abs(x) + std::abs(y));
  if (x + y > limit) return 1;
  if (-(x + y) > limit) return -1;
  return (difference(b.x, a.x) * difference(d.x, c.x) + difference(b.y, a.y) * difference(d.y, c.y)).sign();
}

int turn_sign(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  constexpr double unit = 0x1p-53, bound = (3 + 16 * unit) * unit;
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  const double limit = bound * (std::abs(left) + std::abs(right));
  if (left - right > limit) return 1;
  if (right - left > limit) return -1;
  return (difference(b.x, a.x) * difference(d.y, c.y) - difference(b.y, a.y) * difference(d.x, c.x)).sign();
}

}  // namespace lambert::polygon
