#pragma once
#include "lambert/base/rgb.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::pbrt {

/// The colour of a standard illuminant ("stdillum-A", "stdillum-D65", "stdillum-E", "stdillum-F2", "illum-acesD60", …)
/// as linear Rec. 709 of luminance 1, from its chromaticity; parts outside of the gamut are negative.
std::optional<Rgb> named_illuminant(std::string_view name);
std::vector<std::string> illuminant_names();

}  // namespace lambert::pbrt
