#pragma once
/// First-order regression over windows: the heart of Bitterli et al., "Nonlinearly Weighted First-Order Regression for
/// Denoising Monte Carlo Renderings" (2016).
///
/// Around each second pixel p the colour is modelled as α + β·(f(q) - f(p)), where f are the features (guides, and the
/// place); α and β minimise Σ_q w(p, q) ‖y(q) - α - β·(f(q) - f(p))‖² + ridge, with the weights of non-local means.
/// Each model then speaks for all pixels of its window, again by these weights, and a pixel's value is the mean of what
/// it is told.

#include "lambert/image/denoise/plane.h"

#include <array>
#include <span>
#include <vector>

namespace lambert::denoise {

struct RegressionSettings {
  int window_radius = 6;
  int patch_radius = 3;
  float ridge = 3e-4f;  ///< squared change of a feature that is not worth a slope
  bool place = true;    ///< x and y are features
};

/// The results for the kernel widths k = 1 and k = 1/2.
constexpr std::size_t candidate_count = 2;
using Candidates = std::array<Colour, candidate_count>;

/// Filters `colour` by the patches of `guide` (whose noise has `variance`) and `features`, of which there may be none.
Candidates regress(const Colour& colour, const Colour& guide, const Colour& variance, std::span<const Plane> features,
                   const RegressionSettings& settings);

}  // namespace lambert::denoise
