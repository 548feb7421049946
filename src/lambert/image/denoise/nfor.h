#pragma once
#include "lambert/image/denoise/noisy_image.h"
#include "lambert/image/denoise/regression.h"

namespace lambert::denoise {

struct NforSettings {
  RegressionSettings regression;
  int feature_window_radius = 5;  ///< of the guides' own filter
  int blend_radius = 4;           ///< pixels over which errors are averaged before the kernels are blended
};

/// Bitterli et al. 2016 with these differences: colour is first divided by the albedo, so that textures are no noise;
/// the place is a feature beside the guides; weights know smoothed colour too; one window in eight pixels speaks for
/// those between; the kernels are blended, not chosen.
///
///   1. The guides are freed of their own noise by non-local means.
///   2. Each half is filtered by first-order regression whose weights come from the other half, with a wide kernel and
///      a narrow one: u(A) and v(A).
///   3. The error of a filtered half f(A) is seen against the other: E‖f(A) - B‖² = E‖f(A) - truth‖² + Var B; the error
///      of the mean of both filtered halves is the mean of their errors less ‖f(A) - f(B)‖² / 4. Averaged over some
///      pixels, this is a quadratic function of the share s of v, with minimum s = (e_uu - e_uv) / (e_uu - 2 e_uv +
///      e_vv), where e_uv is the mean product of the errors of u and v. Noise in e_uu - e_uv is met by a ridge, a
///      fiftieth of Var B in the denominator: about what errors averaged over 9x9 pixels leave of it. The shares are
///      smoothed.
/// The light that the file tells apart as emission is filtered by itself and added.
Colour denoise_nfor(const NoisyImage& image, const NforSettings& settings = {}, const FractionSink& progress = {});

}  // namespace lambert::denoise
