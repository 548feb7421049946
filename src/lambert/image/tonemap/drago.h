#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/fast_math.h"
#include "lambert/image/tonemap/luminance_map.h"

#include <cmath>

namespace lambert::tone {

/// Drago, Myszkowski, Annen, Chiba, "Adaptive logarithmic mapping for displaying high contrast scenes" (2003), eq. 4:
/// a logarithm whose base goes from 2 for the darkest to 10 for the brightest. Luminances are relative to the map's
/// log-average; the largest becomes 1 (the paper's 100 cd/m^2 of the display are our white).
struct Drago {
  static constexpr const char *name = "drago", *summary = "Drago 2003: logarithms with a base that adapts";
  float bias = 0.85f;

  std::vector<Setting> settings() {
    return {{"bias", "how fast the base goes from 2 to 10; less is brighter", &bias, {}, {}, 0.0f, 1.0f}};
  }
  auto curve(const LuminanceMap& map) const {
    const float adaptation = 1 / map.statistics.log_average;
    const float largest = map.statistics.largest * adaptation;
    const float exponent = bias < 1 ? std::log(bias) / std::log(0.5f) : 0.0f;
    // ln(L + 1) / (log10(Lmax + 1) ln(2 + 8 (L/Lmax)^exponent)), in which the kind of logarithm cancels but for one.
    const float scale = 1 / std::log10(largest + 1);
    return [=, inverse = 1 / largest](float luminance) {
      const float l = luminance * adaptation;
      const float share = at_least(l * inverse, 1e-30f);
      const float base = 2 + 8 * fast_pow(share, exponent);
      return scale * fast_log2(1 + l) / fast_log2(base);
    };
  }
};

}  // namespace lambert::tone
