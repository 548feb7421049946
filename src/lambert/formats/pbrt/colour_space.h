#pragma once
#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"

#include <string>
#include <string_view>
#include <vector>

namespace lambert::pbrt {

/// The primaries that RGB numbers in the file refer to.
class ColourSpace {
 public:
  ColourSpace() = default;  ///< srgb
  /// "srgb", "dci-p3", "rec2020" or "aces2065-1"; throws Error without a place for other names.
  explicit ColourSpace(std::string_view name);
  static std::vector<std::string> names();

  /// Linear Rec. 709; white stays white (Bradford adaptation).
  Rgb to_rec709(Rgb c) const;
  bool is_srgb() const { return is_srgb_; }

 private:
  Mat3 to_rec709_{1};
  bool is_srgb_ = true;
};

}  // namespace lambert::pbrt
