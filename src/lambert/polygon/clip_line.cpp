#include "lambert/polygon/clip_line.h"

#include "lambert/polygon/exact_cross.h"
#include "lambert/polygon/scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert::polygon {
namespace {

/// from / (from - to) for numbers of different sign.
template <class Real>
double crossing_parameter(Real from, Real to) {
  return static_cast<double>(from / (from - to));
}

double interpolate(double a, double b, double t) {
  const double mixed = a + t * (b - a);
  return mixed >= std::min(a, b) && mixed <= std::max(a, b) ? mixed : (t < 0.5 ? a : b);
}

/// Where the line through low and high divides the way from a to b.
template <class Real>
double divided_at(Vec2d low, Vec2d high, Vec2d a, Vec2d b) {
  const Real from = exact_cross<Real>(a, low, a, high).estimate(), to = exact_cross<Real>(b, low, b, high).estimate();
  return crossing_parameter(from, to);
}

}  // namespace

Vec2d ClipLine::crossing(Vec2d a, Vec2d b) const {
  const bool fit = products_fit<2>({tail, head, a, b});
  if (!fit) {
    const Sizes sizes = sizes_of(std::array{tail, head, a, b});
    // Differences of the largest doubles overflow.
    const double scale = sizes.most > 0x1p1020 ? 0x1p-8 : safe_scale(sizes);
    if (scale != 1) return ClipLine{scale * tail, scale * head}.crossing(scale * a, scale * b) / scale;
  }
  if (compare_xy(b, a) < 0) std::swap(a, b);
  if (is_vertical()) return {tail.x, interpolate(a.y, b.y, crossing_parameter(a.x - tail.x, b.x - tail.x))};
  if (is_horizontal()) return {interpolate(a.x, b.x, crossing_parameter(a.y - tail.y, b.y - tail.y)), tail.y};
  const bool ahead = compare_xy(tail, head) < 0;
  const Vec2d low = ahead ? tail : head, high = ahead ? head : tail;
  const double t =
      products_fit<2>({low, high, a, b}) ? divided_at<double>(low, high, a, b) : divided_at<WideReal>(low, high, a, b);
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

}  // namespace lambert::polygon
