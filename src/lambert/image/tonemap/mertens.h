#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/image.h"
#include "lambert/image/tonemap/luminance_map.h"

#include <span>
#include <vector>

namespace lambert::tone {

/// Mertens, Kautz, Van Reeth, "Exposure fusion" (2007): a stack of exposures is blended by Laplacian pyramids, each
/// pixel by its contrast, its saturation and how near it is to the middle of the display's range. No radiance map is
/// needed; of one, a stack of exposures about its log-average is made. What differs: each measure counts as at least
/// 0.001, so that of pixels without contrast or colour the others decide; of stacks without colour, saturation is left
/// out.
struct Mertens {
  static constexpr const char *name = "mertens", *summary = "Mertens 2007: fusion of exposures, of one map or of files";
  float contrast = 1, saturation = 1, exposedness = 1;  ///< exponents of the measures
  int exposures = 5;
  float step = 2;
  float key = 0.18f;

  std::vector<Setting> settings() {
    return {{"contrast", "exponent of that measure", &contrast, {}, 0, {}, 8.0f},
            {"saturation", "exponent of that measure", &saturation, {}, 0, {}, 8.0f},
            {"exposedness", "exponent of that measure", &exposedness, {}, 0, {}, 8.0f},
            {"exposures", "made of a radiance map", &exposures, {}, 1, {}, 32.0f},
            {"step", "stops between these exposures", &step, {}, {}, 0.0f, 16.0f},
            {"key", "where the middle exposure puts the log-average", &key, {}, {}, 0.0f}};
  }
  void map(RgbPlanes& planes, const LuminanceMap& map) const;
};

/// The fusion of a stack of images of display light in [0, 1] (linear, as read_image gives PNG or JPEG), with alpha and
/// metadata of the first. Throws Error when there is none or their sizes differ.
Image fuse_exposures(std::span<const Image> stack, const Mertens& settings = {});

}  // namespace lambert::tone
