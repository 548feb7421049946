#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

#include <limits>

namespace lambert::tone {

/// L/(1+L), with slope 1 at 0 and limit 1 (row LF-24, E-LF-04); with a white W it is L(1+L/W^2)/(1+L), which reaches 1
/// at W (Reinhard et al. 2002, eq. 3 and 4).
struct Reinhard {
  static constexpr const char *name = "reinhard", *summary = "L/(1+L): leaves the dark alone, never reaches white";
  float white = 0;  ///< the luminance that becomes 1; 0: none does

  std::vector<Setting> settings() {
    return {{"white", "the luminance that becomes white; 0: none does", &white, {}, 0}};
  }
  auto curve(const LuminanceMap&) const {
    const float burn = white > 0 ? 1 / (white * white) : 0.0f;
    return [burn](float l) { return l * (1 + l * burn) / (1 + l); };
  }
};

/// Reinhard, Stark, Shirley, Ferwerda, "Photographic tone reproduction for digital images" (2002), eq. 1, 2 and 4: the
/// log-average luminance is placed at the key, then Reinhard's curve with a white.
struct Photographic {
  static constexpr const char *name = "photographic",
                              *summary = "Reinhard 2002, global: the log-average at the key, the brightest white";
  float key = 0.18f;
  float white = 0;  ///< after scaling to the key; 0: the largest luminance of the map

  std::vector<Setting> settings() {
    return {{"key", "where the log-average goes, before compression", &key, {}, {}, 0.0f},
            {"white", "the scaled luminance that becomes white; 0: the largest", &white, {}, 0}};
  }
  auto curve(const LuminanceMap& map) const {
    const float scale = key / map.statistics.log_average;
    const float top = white > 0 ? white : map.statistics.largest * scale;
    return [scale, burn = 1 / (top * top)](float luminance) {
      const float l = luminance * scale;
      return l * (1 + l * burn) / (1 + l);
    };
  }
};

}  // namespace lambert::tone
