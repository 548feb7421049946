#pragma once
#include "lambert/image/denoise/noisy_image.h"
#include "lambert/image/denoise/regression.h"

namespace lambert::denoise {

struct NforSettings {
  RegressionSettings regression;
  int feature_window_radius = 5;  ///< of the guides' own filter
  int selection_radius = 4;       ///< pixels over which errors are averaged before the better candidate is chosen
};

/// Bitterli et al. 2016 with these differences: colour is first divided by the albedo, so that textures are no noise;
/// the place is a feature beside the guides; every second window in both directions speaks for the pixels between.
///
///   1. The guides are freed of their own noise by non-local means.
///   2. Each half is filtered by first-order regression whose weights come from the other half, with two kernel widths.
///   3. The error of a filtered half f(A) is seen against the other: E‖f(A) - B‖² = E‖f(A) - truth‖² + Var B; the error
///      of the mean of both filtered halves is the mean of their errors less ‖f(A) - f(B)‖² / 4. Averaged over some
///      pixels, it decides between the widths, and the decisions are smoothed.
/// The light that the file tells apart as emission is filtered by itself and added.
Colour denoise_nfor(const NoisyImage& image, const NforSettings& settings = {});

}  // namespace lambert::denoise
