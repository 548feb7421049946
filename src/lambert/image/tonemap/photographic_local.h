#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

namespace lambert::tone {

/// Reinhard et al. 2002, section 3.2, dodging and burning: L/(1 + V), where V is the mean of L under the largest
/// Gaussian about the pixel in which there is no strong contrast (eq. 5 to 9).
struct PhotographicLocal {
  static constexpr const char *name = "photographic-local",
                              *summary = "Reinhard 2002 with dodging and burning: local contrast is kept";
  float key = 0.18f;
  float sharpness = 8;      ///< phi
  float threshold = 0.05f;  ///< epsilon
  int scales = 8;           ///< each 1.6 times the one before, the first one pixel

  std::vector<Setting> settings() {
    return {{"key", "where the log-average goes, before compression", &key, {}, {}, 0.0f},
            {"sharpness", "phi of the paper: more keeps more edges apart", &sharpness, {}, 0},
            {"threshold",
             "epsilon of the paper: contrast that ends the growth of the neighbourhood",
             &threshold,
             {},
             {},
             0.0f},
            {"scales", "sizes of neighbourhoods, each 1.6 times the last", &scales, {}, 1, {}, 16.0f}};
  }
  Plane map(const LuminanceMap& map) const;
};

}  // namespace lambert::tone
