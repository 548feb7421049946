#include "lambert/polygon/line_order.h"

#include "lambert/polygon/accurate.h"
#include "lambert/polygon/exact_cross.h"
#include "lambert/polygon/predicates.h"

namespace lambert::polygon {
namespace {

/// Where both are on one side, or one of them on neither: that side; 0 when they are on both sides or none.
int common_side(int p, int q) { return p * q < 0 ? 0 : p + q; }

}  // namespace

// What crosses the line to its left has the way that leads up to the crossing on its own left side.
int LineOrder::compare(const LinePlace& p, const LinePlace& q) const {
  if (p.is_vertex() && q.is_vertex()) return -dot_sign(p.left, q.left, a_, b_);
  if (p.is_vertex()) return -orientation(q.right, q.left, p.left);
  if (q.is_vertex()) return orientation(p.right, p.left, q.left);
  const int r = orientation(p.right, p.left, q.right), l = orientation(p.right, p.left, q.left);
  if (r == 0 && l == 0) return 0;
  if (const int side = common_side(r, l)) return side > 0 ? 1 : -1;
  const int side = common_side(orientation(q.right, q.left, p.right), orientation(q.right, q.left, p.left));
  if (side != 0) return side > 0 ? -1 : 1;
  return compare_crossings(p, q);
}

/// Of two edges that cross each other. The parameters are n / m with n = (right - a) x (left - right) and
/// m = (b - a) x (left - right) > 0.
int LineOrder::compare_crossings(const LinePlace& p, const LinePlace& q) const {
  {
    const RoundedCross np = rounded_cross(a_, p.right, p.right, p.left), mp = rounded_cross(a_, b_, p.right, p.left);
    const RoundedCross nq = rounded_cross(a_, q.right, q.right, q.left), mq = rounded_cross(a_, b_, q.right, q.left);
    // Each cross product is off by at most 4.1 units of its size; their product by 9.2. The constants cover products
    // below 2^-1022.
    const double difference = np.value * mq.value - nq.value * mp.value;
    const double limit = 12 * 0x1p-53 * (np.size * mq.size + nq.size * mp.size) +
                         0x1p-1070 * (np.size + mq.size + nq.size + mp.size) + 0x1p-1070;
    if (difference > limit) return 1;
    if (-difference > limit) return -1;
  }
  return decide_exactly<4>({a_, b_, p.right, p.left, q.right, q.left}, [&](auto zero) {
    using Real = decltype(zero);
    const auto np = exact_cross<Real>(a_, p.right, p.right, p.left), mp = exact_cross<Real>(a_, b_, p.right, p.left);
    const auto nq = exact_cross<Real>(a_, q.right, q.right, q.left), mq = exact_cross<Real>(a_, b_, q.right, q.left);
    return (np * mq - nq * mp).sign();
  });
}

double LineOrder::parameter(const LinePlace& p) const {
  if (p.is_vertex()) {
    if (p.left == b_) return 1;
    if (products_fit<2>({p.left, a_, b_})) return dot(p.left - a_, b_ - a_) / dot(b_ - a_, b_ - a_);
    const auto along = [&](Vec2d q) {
      WideReal sum = 0;
      for (int i = 0; i < 2; ++i)
        sum += (static_cast<WideReal>(q[i]) - static_cast<WideReal>(a_[i])) *
               (static_cast<WideReal>(b_[i]) - static_cast<WideReal>(a_[i]));
      return sum;
    };
    return static_cast<double>(along(p.left) / along(b_));
  }
  return accurate_quotient({a_, p.right, p.right, p.left}, {a_, b_, p.right, p.left});
}

Vec2d LineOrder::point(const LinePlace& p) const {
  if (p.is_vertex()) return p.left;
  Vec2d point = point_between(p.right, p.left, accurate_quotient({p.right, a_, a_, b_}, {p.right, p.left, a_, b_}));
  if (a_.x == b_.x) point.x = a_.x;
  if (a_.y == b_.y) point.y = a_.y;
  return point;
}

}  // namespace lambert::polygon
