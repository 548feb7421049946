#include "lambert/polygon/clip_line.h"

#include "lambert/polygon/expansion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert::polygon {
namespace {

Expansion<2> difference(double a, double b) { return Expansion<2>(two_sum(a, -b)); }

/// Twice the area of a triangle within a few roundings of its exact value.
double accurate_cross(Vec2d a, Vec2d b, Vec2d c) {
  return (difference(a.x, c.x) * difference(b.y, c.y) - difference(a.y, c.y) * difference(b.x, c.x)).estimate();
}

/// from / (from - to) for numbers of different sign, in [0, 1] whatever overflows.
double crossing_parameter(double from, double to) {
  const double t = from / (from - to);
  return t >= 0 && t <= 1 ? t : 0.5;
}

double interpolate(double a, double b, double t) {
  const double mixed = a + t * (b - a);
  return mixed >= std::min(a, b) && mixed <= std::max(a, b) ? mixed : (t < 0.5 ? a : b);
}

/// The line through two points: a x + b y + c = 0, positive on the left.
struct Coefficients {
  Expansion<2> a, b;
  Expansion<4> c;
};

Coefficients coefficients(Vec2d p, Vec2d q) {
  return {difference(p.y, q.y), difference(q.x, p.x),
          Expansion<2>(two_product(p.x, q.y)) - Expansion<2>(two_product(p.y, q.x))};
}

}  // namespace

Vec2d ClipLine::crossing(Vec2d a, Vec2d b) const {
  if (compare_xy(b, a) < 0) std::swap(a, b);
  if (is_vertical()) return {tail.x, interpolate(a.y, b.y, crossing_parameter(a.x - tail.x, b.x - tail.x))};
  if (is_horizontal()) return {interpolate(a.x, b.x, crossing_parameter(a.y - tail.y, b.y - tail.y)), tail.y};
  const double t = crossing_parameter(accurate_cross(tail, head, a), accurate_cross(tail, head, b));
  return {interpolate(a.x, b.x, t), interpolate(a.y, b.y, t)};
}

int ClipLine::compare_along(Vec2d a, Vec2d b) const {
  const int along_x = compare(a.x, b.x) * compare(head.x, tail.x);
  const int along_y = compare(a.y, b.y) * compare(head.y, tail.y);
  const bool flat = std::abs(head.x - tail.x) >= std::abs(head.y - tail.y);
  if (flat ? along_x != 0 : along_y != 0) return flat ? along_x : along_y;
  if (flat ? along_y != 0 : along_x != 0) return flat ? along_y : along_x;
  return compare_xy(a, b);
}

int compare_crossings(const ClipLine& line, Vec2d left_1, Vec2d right_1, Vec2d left_2, Vec2d right_2) {
  // An edge runs from left to right of the line, so that what comes later along the line is on the edge's left. When
  // both ends of one edge are on the same side of the other, so is its crossing.
  const int l2 = orientation(left_1, right_1, left_2), r2 = orientation(left_1, right_1, right_2);
  if (l2 * r2 >= 0) return l2 + r2 > 0 ? -1 : (l2 + r2 < 0 ? 1 : 0);
  const int l1 = orientation(left_2, right_2, left_1), r1 = orientation(left_2, right_2, right_1);
  if (l1 * r1 >= 0) return l1 + r1 > 0 ? 1 : -1;

  // The edges cross each other. The first edge meets the line where the second one's equation has the value
  // det(line, edge 1, edge 2) / cross(direction of line, direction of edge 1), whose divisor is negative.
  std::array<Vec2d, 6> p{line.tail, line.head, left_1, right_1, left_2, right_2};
  double largest = 0;
  for (const Vec2d q : p) largest = std::max({largest, std::abs(q.x), std::abs(q.y)});
  const int exponent = std::ilogb(largest);
  for (Vec2d& q : p) q = {std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent)};
  const Coefficients l = coefficients(p[0], p[1]), e = coefficients(p[2], p[3]), f = coefficients(p[4], p[5]);
  const auto determinant =
      (e.a * f.b - e.b * f.a) * l.c + (f.a * l.b - f.b * l.a) * e.c + (l.a * e.b - l.b * e.a) * f.c;
  return -determinant.sign();
}

}  // namespace lambert::polygon
