#pragma once
#include "lambert/image/filter/pyramid.h"
#include "lambert/image/image.h"

namespace lambert {

/// A plane covered with a repeated texture, seen by a pinhole at a height of 1 above it that looks at the horizon; the
/// upper half of the picture is the sky. Shows what a lookup does with a footprint that grows without bound.
struct TexturedPlane {
  int width = 256, height = 256;
  float repeat = 2;          ///< length of the texture's side, in heights of the pinhole
  float field_of_view = 90;  ///< across, in degrees, above 0 and below 180
  int samples = 1;           ///< per pixel and axis; with many the lookup no longer matters
  LookupSettings lookup;
};
/// R, G, B. Throws Error for a setting out of range.
Image textured_plane(const Pyramid& texture, const TexturedPlane& settings = {});

/// Black and white squares, cells × cells of them, `size` pixels along each side, white at the top left.
Image checkerboard(int size, int cells);

}  // namespace lambert
