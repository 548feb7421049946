#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

#include <algorithm>

namespace lambert::tone {

/// Narkowicz, "ACES filmic tone mapping curve" (2015): a rational fit of the ACES reference rendering curve for each
/// channel, made for an exposure of 0.6.
struct Filmic {
  static constexpr const char *name = "filmic", *summary = "Narkowicz 2015: a rational fit of the ACES curve";
  float gain = 0.6f;

  std::vector<Setting> settings() { return {{"gain", "on radiance before the curve", &gain, {}, {}, 0.0f}}; }
  auto colour_curve(const LuminanceMap&) const {
    return [g = gain](Rgb c) {
      // Beyond, the curve is flat, and its squares overflow.
      const auto fit = [g](float v) {
        const float x = std::min(v * g, 1e9f);
        return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
      };
      return Rgb(fit(c.r), fit(c.g), fit(c.b));
    };
  }
};

}  // namespace lambert::tone
