#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

namespace lambert::tone {

/// Proportional, clipped at white: row LF-21.
struct Linear {
  static constexpr const char *name = "linear", *summary = "proportional; what is brighter than white is clipped";
  float white = 1;  ///< the luminance shown as white; 0: the largest of the map

  std::vector<Setting> settings() {
    return {{"white", "the luminance shown as white; 0: the largest of the map", &white, {}, 0}};
  }
  auto curve(const LuminanceMap& map) const {
    const float scale = 1 / (white > 0 ? white : map.statistics.largest);
    return [scale](float l) { return l * scale; };
  }
};

}  // namespace lambert::tone
