#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

#include <string>

namespace lambert::tone {

/// The display transform of an OpenColorIO configuration, that of $OCIO. The library is loaded when this is used, from
/// lambert_ocio.so beside the program or in ../lib/lambert. Its result is taken for sRGB codes, which files then hold
/// unchanged. map() throws Error when the module, $OCIO, or a name in it is missing.
struct Ocio {
  static constexpr const char *name = "ocio",
                              *summary = "a display transform of the OpenColorIO configuration in $OCIO";
  std::string display, view, input;

  std::vector<Setting> settings() {
    return {{"display", "empty: the default of the configuration", &display},
            {"view", "empty: the default of the display", &view},
            {"input", "the colour space of the map; empty: the role scene_linear", &input}};
  }
  void map(RgbPlanes& planes, const LuminanceMap& map) const;
  /// Whether $OCIO is set and the module is there.
  static bool available();
};

}  // namespace lambert::tone
