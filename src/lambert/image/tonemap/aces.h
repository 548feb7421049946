#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"
#include "lambert/image/tonemap/rgb_matrix.h"

#include <algorithm>

namespace lambert::tone {

/// Hill's fit of the ACES reference rendering transform with the output transform for 100 nit Rec. 709 displays (2016).
/// The matrices are computed from the primaries: Rec. 709 to AP1, there the transform's loss of saturation (0.96), the
/// rational fit of its curve for each channel, the display's loss (0.93) and back. A grey of 0.18 becomes 0.10.
struct Aces {
  static constexpr const char *name = "aces", *summary = "Hill 2016: a fit of the ACES transforms, with their colours";
  float gain = 1;

  std::vector<Setting> settings() { return {{"gain", "on radiance before the transform", &gain, {}, {}, 0.0f}}; }

  auto colour_curve(const LuminanceMap&) const {
    const RgbMatrix in(input_matrix() * static_cast<double>(gain)), out(output_matrix());
    return [in, out](Rgb c) {
      const Rgb v = in(c);
      return out(Rgb(fit(v.r), fit(v.g), fit(v.b)));
    };
  }

  static Matrix3d input_matrix();
  static Matrix3d output_matrix();
  static float fit(float v) {
    const float x = std::min(std::max(v, 0.0f), 1e9f);
    return (x * (x + 0.0245786f) - 0.000090537f) / (x * (0.983729f * x + 0.4329510f) + 0.238081f);
  }
};

}  // namespace lambert::tone
