#pragma once
#include "lambert/image/image.h"
#include "lambert/image/plane.h"

namespace lambert::compare {

struct Similarity {
  double mean = 1;
  Plane map;  ///< per pixel, in [-1, 1]
};

/// Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004) of luminance: Gaussian window of 11 x 11 and sigma 1.5,
/// K1 = 0.01, K2 = 0.03, values expected in [0, 1]. The border is repeated outwards, so every pixel has a value; the
/// paper leaves the margin open. Values that are not finite count as 0. Throws Error unless the sizes are equal.
Similarity ssim(const Image& a, const Image& b);

}  // namespace lambert::compare
