#include "lambert/image/tonemap/photographic_local.h"

#include "lambert/image/filter/blur.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::tone {

Plane PhotographicLocal::map(const LuminanceMap& map) const {
  const int height = map.luminance.height;
  const std::size_t width = static_cast<std::size_t>(map.luminance.width);
  Plane scaled = map.luminance;
  Image light(scaled.width, height, {"Y"});
  const float scale = key / map.statistics.log_average;
  for_rows(height, [&](int y) {
    for (float& v : scaled.row(y)) v *= scale;
    std::ranges::copy(scaled.row(y), light.row(y).begin());
  });
  // The paper's profile exp(-r^2/(a s)^2) with a = 1/(2 sqrt 2) has the standard deviation s/4.
  const auto neighbourhood = [&](float size) { return gaussian_blurred(light, Vec2(size / 4)); };
  constexpr float ratio = 1.6f;
  float size = 1;
  Image centre = neighbourhood(size), chosen = centre;
  Plane growing(scaled.width, height, 1);
  for (int i = 0; i < scales; ++i, size *= ratio) {
    Image surround = neighbourhood(size * ratio);
    const float base = std::exp2(sharpness) * key / (size * size);
    for_rows(height, [&](int y) {
      float* const grows = growing.row(y).data();
      float* const best = chosen.row(y).data();
      const float* const inner = centre.row(y).data();
      const float* const outer = surround.row(y).data();
      for (std::size_t x = 0; x < width; ++x) {
        best[x] = grows[x] > 0 ? inner[x] : best[x];
        grows[x] = std::abs(inner[x] - outer[x]) < threshold * (base + inner[x]) ? grows[x] : 0.0f;
      }
    });
    centre = std::move(surround);
  }
  for_rows(height, [&](int y) {
    float* const value = scaled.row(y).data();
    const float* const around = chosen.row(y).data();
    for (std::size_t x = 0; x < width; ++x) value[x] /= 1 + around[x];
  });
  return scaled;
}

}  // namespace lambert::tone
