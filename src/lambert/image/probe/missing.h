#pragma once
#include "lambert/image/image.h"

#include <cstddef>

namespace lambert::probe {

/// Gives every texel with a number that is not finite the mean of its finite neighbours in all channels, from the rim
/// of such places inwards; 0 when the whole image is so. Returns how many texels there were, so that it can be said.
std::size_t fill_missing(Image& image);

}  // namespace lambert::probe
