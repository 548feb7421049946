#include "lambert/image/probe/octahedral.h"

#include <algorithm>
#include <cmath>

namespace lambert::probe {
namespace {

/// Beyond an edge of the square the map goes on mirrored about that edge's middle.
Vec2 folded(Vec2 uv) {
  if (uv.x < 0 || uv.x > 1) uv = Vec2(uv.x < 0 ? -uv.x : 2 - uv.x, 1 - uv.y);
  if (uv.y < 0 || uv.y > 1) uv = Vec2(1 - uv.x, uv.y < 0 ? -uv.y : 2 - uv.y);
  return uv;
}

}  // namespace

std::optional<Vec3> Octahedral::direction(MapPoint at) const {
  const Vec2 p = 2.0f * folded(at.uv) - 1.0f;
  Vec3 d(p, 1 - std::abs(p.x) - std::abs(p.y));
  if (d.z < 0) {
    d.x = std::copysign(1 - std::abs(p.y), p.x);
    d.y = std::copysign(1 - std::abs(p.x), p.y);
  }
  return normalize(d);
}

std::optional<MapPoint> Octahedral::point(Vec3 d) const {
  Vec2 p = Vec2(d) / (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
  if (d.z < 0) p = Vec2(std::copysign(1 - std::abs(p.y), d.x), std::copysign(1 - std::abs(p.x), d.y));
  return MapPoint{0, 0.5f * (p + 1.0f)};
}

/// A facet's point q has q·n = 1/√3, a facet's area is √3 times that of its image on the square of side 2: in all
/// dω = (1/√3) / |q|³ · √3 · 4 du dv.
float Octahedral::density(MapPoint at) const {
  const Vec2 p = 2.0f * folded(at.uv) - 1.0f;
  float x = std::abs(p.x), y = std::abs(p.y);
  const float z = 1 - x - y;
  if (z < 0) {
    const float other = 1 - x;
    x = 1 - y, y = other;
  }
  const float q2 = x * x + y * y + z * z;
  return 4 / (q2 * std::sqrt(q2));
}

std::optional<Vec3> EqualArea::direction(MapPoint at) const { return equal_area_square_to_sphere(folded(at.uv)); }

std::optional<MapPoint> EqualArea::point(Vec3 d) const { return MapPoint{0, equal_area_sphere_to_square(d)}; }

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
  const float r = std::hypot(d.x, d.y) / std::sqrt(1 + std::abs(d.z));      // = √(1 - |z|)
  const float angle = std::atan2(std::abs(d.y), std::abs(d.x)) * (2 / pi);  // of a quarter turn
  Vec2 p(r - angle * r, angle * r);
  if (d.z < 0) p = Vec2(1 - p.y, 1 - p.x);
  return 0.5f * (Vec2(std::copysign(p.x, d.x), std::copysign(p.y, d.y)) + 1.0f);
}

}  // namespace lambert::probe
