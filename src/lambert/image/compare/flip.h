#pragma once
/// The difference that a viewer notices when two images alternate.

#include "lambert/image/image.h"
#include "lambert/image/plane.h"

namespace lambert::compare {

struct FlipSettings {
  /// How many pixels an eye sees in a degree; the default is a 0.7 m wide screen of 3840 pixels, 0.7 m away.
  double pixels_per_degree = 67.0206;
};

struct Flip {
  double mean = 0;  ///< in [0, 1]
  Plane map;        ///< per pixel, in [0, 1]
};

/// FLIP (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020) of images whose linear RGB is shown as
/// it is: values are clipped to [0, 1]. Symmetric. Values that are not finite count as 0. Throws Error unless the sizes
/// are equal and the settings positive.
Flip flip(const Image& a, const Image& b, const FlipSettings& settings = {});

/// HDR-FLIP (Andersson, Nilsson, Shirley, Akenine-Möller 2021): the largest FLIP, per pixel, over exposures from where
/// the reference's brightest luminance to where its median reaches 0.85 through the ACES curve (Narkowicz 2015), at
/// most one stop apart. Not symmetric: `reference` sets the exposures.
Flip hdr_flip(const Image& image, const Image& reference, const FlipSettings& settings = {});

}  // namespace lambert::compare
