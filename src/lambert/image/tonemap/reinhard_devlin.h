#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

namespace lambert::tone {

/// Reinhard and Devlin, "Dynamic range reduction inspired by photoreceptor physiology" (2005): each channel is
/// I/(I + (f Ia)^m), where the adaptation Ia goes from the map's average to the pixel (`light`) and from luminance to
/// the channel (`chromatic`); at last the result is stretched to [0, 1].
struct ReinhardDevlin {
  static constexpr const char *name = "reinhard-devlin", *summary = "Reinhard-Devlin 2005: like photoreceptors";
  float intensity = 0;  ///< more is brighter; f = exp(-intensity)
  float contrast = 0;   ///< the exponent m; 0: from the map's key
  float light = 1, chromatic = 0;

  std::vector<Setting> settings() {
    return {{"intensity", "brightness, about -8 to 8", &intensity},
            {"contrast", "0.3 to 1; 0: from the map", &contrast, {}, 0, {}, 4.0f},
            {"light", "adaptation to the map (0) or to the pixel (1)", &light, {}, 0, {}, 1.0f},
            {"chromatic", "adaptation to luminance (0) or to the channel (1)", &chromatic, {}, 0, {}, 1.0f}};
  }
  void map(RgbPlanes& planes, const LuminanceMap& map) const;
  /// The exponent that the paper takes from the key of a map.
  static float contrast_of(const LuminanceStatistics& statistics);
};

}  // namespace lambert::tone
