#pragma once
/// Non-local means for noise of known variance (Rousselle, Knaus and Zwicker 2012).

#include "lambert/base/progress.h"
#include "lambert/image/denoise/noisy_image.h"

#include <span>
#include <vector>

namespace lambert::denoise {

struct NlmSettings {
  int window_radius = 10;  ///< pixels
  int patch_radius = 3;    ///< pixels, 0 to 3
  float k = 0.6f;          ///< strength: patches count as alike that differ by k times their noise
};

/// Filters `planes` by the likeness of the patches of `guides`, whose noise has `variances` (1 to 3 planes each, as
/// many guides as variances). Returns as many planes as it was given. Squares of tile_size pixels without any variance
/// stay exactly as they are.
std::vector<Plane> nl_means(std::span<const Plane> planes, std::span<const Plane> guides,
                            std::span<const Plane> variances, const NlmSettings& settings,
                            const FractionSink& progress = {});

/// Each half by the other's patches, so that the weights know nothing of the noise that they average; their mean.
Colour denoise_nlm(const NoisyImage& image, const NlmSettings& settings = {}, const FractionSink& progress = {});

}  // namespace lambert::denoise
