#pragma once
/// "Darkest 0.1 % scaled to display" (row LF-22). The notes do not say 0.1 % of what: of the range of values, or of the
/// pixels (E-LF-09). The results differ widely: the first leaves most of a common map unclipped, the second shows one
/// pixel in a thousand and the rest white.

#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

namespace lambert::tone {

/// White is a fraction of the largest luminance.
struct DarkestRange {
  static constexpr const char *name = "darkest-range",
                              *summary = "linear up to a fraction (0.1 %) of the largest luminance";
  float fraction = 0.001f;

  std::vector<Setting> settings() {
    return {{"fraction", "of the largest luminance that is shown as white", &fraction, {}, {}, 0.0f, 1.0f}};
  }
  auto curve(const LuminanceMap& map) const {
    const float scale = 1 / (fraction * map.statistics.largest);
    return [scale](float l) { return l * scale; };
  }
};

/// White is the luminance that some percent of the pixels do not exceed.
struct DarkestPixels {
  static constexpr const char *name = "darkest-pixels",
                              *summary = "linear over the darkest 0.1 % of the pixels; all others are white";
  static constexpr bool needs_luminances = true;
  float percent = 0.1f;

  std::vector<Setting> settings() {
    return {{"percent", "of the pixels that are shown darker than white", &percent, {}, 0, {}, 100.0f}};
  }
  auto curve(const LuminanceMap& map) const {
    const float scale = 1 / map.percentile(percent);
    return [scale](float l) { return l * scale; };
  }
};

}  // namespace lambert::tone
