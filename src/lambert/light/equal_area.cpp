#include "lambert/light/equal_area.h"

#include <algorithm>
#include <cmath>

namespace lambert {

// With u, v in [-1, 1] folded to the first quadrant, the diamond u + v <= 1 is the upper hemisphere: r = u + v is the
// radius, and 1 - r² = z; the angle grows evenly along the lines r = const. The corners mirror this below.

Vec3 equal_area_square_to_sphere(Vec2 uv) {
  const float u = 2 * uv.x - 1, v = 2 * uv.y - 1, abs_u = std::abs(u), abs_v = std::abs(v);
  const float signed_distance = 1 - (abs_u + abs_v);
  const float r = 1 - std::abs(signed_distance);
  const float phi = (r == 0 ? 1 : (abs_v - abs_u) / r + 1) * (pi / 4);
  const float z = std::copysign(1 - r * r, signed_distance);
  const float ring = r * std::sqrt(std::max(0.0f, 2 - r * r));
  return {std::copysign(ring * std::cos(phi), u), std::copysign(ring * std::sin(phi), v), z};
}

Vec2 equal_area_sphere_to_square(Vec3 d) {
  const float r = std::sqrt(std::max(0.0f, 1 - std::abs(d.z)));
  const float angle = std::atan2(std::abs(d.y), std::abs(d.x)) * (2 / pi);  // of a quarter turn
  Vec2 p(r - angle * r, angle * r);
  if (d.z < 0) p = Vec2(1 - p.y, 1 - p.x);
  return 0.5f * (Vec2(std::copysign(p.x, d.x), std::copysign(p.y, d.y)) + 1.0f);
}

}  // namespace lambert
