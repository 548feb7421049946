#pragma once
#include "lambert/base/vec.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lambert {

/// The half-line origin + t direction for t in [t_min, t_max]. The direction need not be unit: t is in its lengths.
struct Ray {
  Vec3 origin{0};
  Vec3 direction{0, 0, 1};
  float t_min = 0;
  float t_max = std::numeric_limits<float>::infinity();
  float time = 0;

  Vec3 at(float t) const { return origin + t * direction; }
};

/// The angular footprint of a pixel along a path: its width is `width + spread * distance` (Akenine-Möller et al.,
/// "Texture Level of Detail Strategies for Real-Time Ray Tracing", 2019). Lengths in scene units.
struct RayCone {
  float width = 0;
  float spread = 0;
  float at(float distance) const { return width + spread * distance; }
};

/// Moves a surface point off its surface to the side of `n`, far enough that a ray from there does not hit the surface
/// again: by 256 units in the last place of each coordinate, or a fixed step near the origin
/// (Wächter and Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, ch. 6).
inline Vec3 offset_ray_origin(Vec3 p, Vec3 n) {
  constexpr float near_origin = 1.0f / 32.0f, float_scale = 1.0f / 65536.0f, int_scale = 256.0f;
  const auto offset = [&](float x, float nx) {
    const auto step = static_cast<std::int32_t>(int_scale * nx);
    const float moved = std::bit_cast<float>(std::bit_cast<std::int32_t>(x) + (x < 0 ? -step : step));
    return std::abs(x) < near_origin ? x + float_scale * nx : moved;
  };
  return {offset(p.x, n.x), offset(p.y, n.y), offset(p.z, n.z)};
}

}  // namespace lambert
