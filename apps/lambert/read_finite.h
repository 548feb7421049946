#pragma once
#include "lambert/image/image.h"

#include <string>

namespace lambert::cli {

/// Reads an environment or a photograph for one (probe::whole_map) and fills pixels that are not finite, with a
/// warning; throws Error when none is.
Image read_finite(const std::string& file);

}  // namespace lambert::cli
