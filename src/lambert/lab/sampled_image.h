#pragma once
/// Images of functions of the plane: what a renderer does, without the scene.

#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"
#include "lambert/image/image.h"
#include "lambert/sampling/patterns.h"

#include <cstdint>
#include <functional>

namespace lambert::lab {

/// Linear light at a point, in pixels from the top left corner of the image.
using Scene = std::function<Rgb(Vec2d)>;

struct PixelSampling {
  PatternKind pattern = PatternKind::jittered;
  int samples = 16;  ///< a pixel; square for regular and jittered
  std::uint64_t seed = 1;
};

/// Every pixel the mean of the scene at a pattern of its own (a box filter of one pixel). `seed` and the pixel decide
/// the pattern: threads do not.
Image sampled(const Scene& scene, int width, int height, const PixelSampling& sampling);

/// One pattern of `samples` points a pixel over tiles of 16 x 16 pixels, repeated, so that points of neighbouring
/// pixels know of each other; each pixel is the mean of the points within 3/2 pixels weighted by a Gaussian of sigma
/// 1/2.
Image sampled_by_tiles(const Scene& scene, int width, int height, const PixelSampling& sampling);

/// The root of the mean squared difference of two images of the same size and channels.
double rms_difference(const Image& a, const Image& b);

}  // namespace lambert::lab
