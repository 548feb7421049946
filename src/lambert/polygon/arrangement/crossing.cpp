#include "lambert/polygon/arrangement/crossing.h"

#include "lambert/polygon/predicates/expansion.h"

#include <algorithm>
#include <utility>

namespace lambert::polygon::arrangement {
namespace {

/// (b - a) x (d - c) to a relative error of 2^-50 or so, even where the doubles cancel.
double precise_turn(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  if (std::abs(left - right) > 0x1p-20 * (std::abs(left) + std::abs(right))) return left - right;
  using Difference = Expansion<2>;
  const Difference abx(two_sum(b.x, -a.x)), aby(two_sum(b.y, -a.y)), cdx(two_sum(d.x, -c.x)), cdy(two_sum(d.y, -c.y));
  return (abx * cdy - aby * cdx).estimate();
}

}  // namespace

Vec2d crossing_point(Segment s, Segment t) {
  if (compare_xy(s.b, s.a) < 0) std::swap(s.a, s.b);
  if (compare_xy(t.b, t.a) < 0) std::swap(t.a, t.b);
  if (const int order = compare_xy(t.a, s.a); order < 0 || (order == 0 && compare_xy(t.b, s.b) < 0)) std::swap(s, t);
  const double at = precise_turn(s.a, t.a, t.a, t.b) / precise_turn(s.a, s.b, t.a, t.b);
  // From the nearer end, where the product is smaller and so is its error.
  const Vec2d p = at < 0.5 ? s.a + at * (s.b - s.a) : s.b - (1 - at) * (s.b - s.a);
  const auto within = [](double x, double a0, double b0, double c0, double d0) {
    const double low = std::max(std::min(a0, b0), std::min(c0, d0)),
                 high = std::min(std::max(a0, b0), std::max(c0, d0));
    return std::min(std::max(x, low), high);
  };
  return {within(p.x, s.a.x, s.b.x, t.a.x, t.b.x), within(p.y, s.a.y, s.b.y, t.a.y, t.b.y)};
}

Vec2d crossing_of_parts(Segment s, Segment t, Segment line_of_s, Segment line_of_t) {
  if (segments_cross(line_of_s, line_of_t)) {
    const Vec2d p = crossing_point(line_of_s, line_of_t);
    if (in_box(s, p) && in_box(t, p)) return p;
  }
  return crossing_point(s, t);
}

}  // namespace lambert::polygon::arrangement
