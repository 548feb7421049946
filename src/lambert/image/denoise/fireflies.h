#pragma once
#include "lambert/image/denoise/noisy_image.h"

namespace lambert::denoise {

/// Scales a pixel of one half down where its luminance is more than `factor` times both what the other half says of the
/// same pixel and the fourth largest luminance within two pixels in both halves: a rare path, not a small light.
/// Without measured halves a pixel is trusted whose variance is small. Variances shrink with their pixels.
void clamp_fireflies(NoisyImage& image, float factor);

}  // namespace lambert::denoise
