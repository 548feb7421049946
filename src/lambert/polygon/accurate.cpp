#include "lambert/polygon/accurate.h"

#include "lambert/polygon/exact_cross.h"
#include "lambert/polygon/scale.h"

#include <glm/common.hpp>

#include <array>

namespace lambert::polygon {

double accurate_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const RoundedCross rounded = rounded_cross(a, b, c, d);
  // The three roundings of each product make at most 3.1 units of it, the last one half a unit of the difference.
  if (std::abs(rounded.value) >= 0x1p-2 * rounded.size) return rounded.value;
  return exact_cross<double>(a, b, c, d).estimate();
}

double accurate_quotient(const CrossProduct& n, const CrossProduct& m) {
  const double over = accurate_cross(n.a, n.b, n.c, n.d), under = accurate_cross(m.a, m.b, m.c, m.d);
  const auto safe = [](double v) { return std::abs(v) >= 0x1p-950 && std::abs(v) <= 0x1p1020; };
  if ((safe(over) && safe(under)) || products_fit<2>({n.a, n.b, n.c, n.d, m.a, m.b, m.c, m.d})) return over / under;
  Sizes sizes;
  for (const CrossProduct& p : {n, m}) sizes.add(std::array{p.a, p.b, p.c, p.d});
  if (const double scale = safe_scale(sizes); scale != 1) {
    const auto scaled = [scale](const CrossProduct& p) {
      return CrossProduct{scale * p.a, scale * p.b, scale * p.c, scale * p.d};
    };
    return accurate_quotient(scaled(n), scaled(m));
  }
  return static_cast<double>(exact_cross<WideReal>(n.a, n.b, n.c, n.d).estimate() /
                             exact_cross<WideReal>(m.a, m.b, m.c, m.d).estimate());
}

Vec2d point_between(Vec2d a, Vec2d b, double t) {
  const Vec2d way = b - a;
  if (!std::isfinite(way.x) || !std::isfinite(way.y)) return 2.0 * point_between(0.5 * a, 0.5 * b, t);
  const Vec2d p = t <= 0.5 ? a + t * way : b - (1 - t) * way;
  return glm::clamp(p, glm::min(a, b), glm::max(a, b));
}

}  // namespace lambert::polygon
