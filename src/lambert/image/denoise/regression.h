#pragma once
/// First-order regression over windows: the heart of Bitterli et al., "Nonlinearly Weighted First-Order Regression for
/// Denoising Monte Carlo Renderings" (2016).
///
/// Around pixels p, a quincunx of one in eight, the colour is modelled as α + β·(f(q) - f(p)), where f are the features
/// (guides, and the place); α and β minimise Σ_q w(p, q) ‖y(q) - α - β·(f(q) - f(p))‖² + ridge. The weights are those
/// of non-local means times a bilateral one of smoothed colour, which tells the light of a caustic from the dark beside
/// it where its noise is too strong for patches to. Each model then speaks for all pixels of its window, again by these
/// weights, and a pixel's value is the mean of what it is told.

#include "lambert/base/progress.h"
#include "lambert/image/denoise/plane.h"

#include <array>
#include <span>
#include <vector>

namespace lambert::denoise {

struct RegressionSettings {
  int window_radius = 7;  ///< pixels, at most 10
  int narrow_radius = 4;  ///< of the narrow kernel's window, at most window_radius
  int patch_radius = 1;   ///< pixels, 0 to 3
  float k = 2;            ///< patches count as alike that differ by k times their noise, by the narrow kernel half that
  float colour = 0.3f;    ///< standard deviation of the logarithm of smoothed colours that count as alike
  float ridge = 3e-4f;    ///< squared change of a feature that is not worth a slope
};

/// The results for the wide kernel and the narrow one: a smaller window, and the fourth power of the weights.
constexpr std::size_t candidate_count = 2;
using Candidates = std::array<Colour, candidate_count>;

/// Filters `colour` by the patches of `guide` (whose noise has `variance`) and at most 7 `features`, of which there may
/// be none. The unit of colour is about its mean.
Candidates regress(const Colour& colour, const Colour& guide, const Colour& variance, std::span<const Plane> features,
                   const RegressionSettings& settings, const FractionSink& progress = {});

}  // namespace lambert::denoise
