#pragma once
#include "lambert/image/denoise/noisy_image.h"

namespace lambert::denoise {

struct BilateralSettings {
  int window_radius = 8;  ///< pixels
  float place = 4;        ///< standard deviation in pixels
  float colour = 0.4f;    ///< of colours, relative to the noise and the brightness of the pixel
  float albedo = 0.2f, normal = 0.3f, depth = 0.15f;  ///< depth in units of the mean depth
};

/// Planes whose squared differences, summed, are the exponent of a weight: the logarithm of 1 + |colour|, on which
/// equal steps are equal multiples of the noise, relative for bright pixels, with standard deviation `sigma`. One
/// pixel's colour at this noise says little: the mean over (2 radius + 1)² says more.
Colour colour_axes(Colour colour, int radius, float sigma);

/// The joint (cross) bilateral filter (Petschnigg et al. 2004; Eisemann and Durand 2004): weights fall with the
/// distance in the picture, in colour and in each guide. Each half is weighed by the other; their mean.
Colour denoise_bilateral(const NoisyImage& image, const BilateralSettings& settings = {});

}  // namespace lambert::denoise
