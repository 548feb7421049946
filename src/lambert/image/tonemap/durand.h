#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

namespace lambert::tone {

/// Durand and Dorsey, "Fast bilateral filtering for the display of high-dynamic-range images" (2002): the decimal
/// logarithm of luminance is parted into a base, by a bilateral filter, and the detail; the base is compressed to a
/// contrast, the detail stays. What differs: on the soft edge of a lamp a bilateral filter turns slopes round, so that
/// the detail would draw a dark and a light line along it (Bae, Paris and Durand 2006); there, where values range over
/// several deviations within 0.4 of the filter's width, the base is the picture itself. The base's range is that
/// between its percentiles `clip` and 100 - `clip`, so that one speck does not darken all; luminances below the 0.1th
/// percentile of those above 0 count as that.
struct Durand {
  static constexpr const char *name = "durand", *summary = "Durand-Dorsey 2002: fast bilateral filtering";
  float spatial = 2;   ///< standard deviation, percent of the larger side
  float range = 0.4f;  ///< standard deviation, decades
  float contrast = 5;  ///< of the base, highest to lowest
  float clip = 0.1f;

  std::vector<Setting> settings() {
    return {{"spatial", "deviation of the filter in space, percent of the larger side", &spatial, {}, {}, 0.0f, 50.0f},
            {"range", "deviation of the filter in decades of luminance", &range, {}, {}, 0.0f, 10.0f},
            {"contrast", "of the base layer, highest to lowest", &contrast, {}, 1},
            {"clip", "percent of the base's pixels beyond its range, on either side", &clip, {}, 0, {}, 20.0f}};
  }
  Plane map(const LuminanceMap& map) const;
};

}  // namespace lambert::tone
