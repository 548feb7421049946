#pragma once
#include "lambert/base/vec.h"

#include <array>

namespace lambert {

/// What one pixel covers of a texture, to first order: how (u, v) changes from a pixel to the next along the picture's
/// x and y. Both in uv (the whole image is 1).
struct Footprint {
  Vec2 dx{0}, dy{0};
};

/// Row AA-21: D, the largest of the lengths of the pixel's four edges in the texture, in texels of level 0 (E-AA-06).
double largest_edge(const Footprint& in_texels);
/// The same of a pre-image that is any quadrilateral, corners in order.
double largest_edge(const std::array<Vec2d, 4>& corners_in_texels);

/// Where log2 D lies among the levels of a pyramid: `level` and, by `fraction`, level + 1; 0 where D <= 1, the last
/// level where the pyramid ends.
struct LevelChoice {
  int level = 0;
  double fraction = 0;
};
LevelChoice level_for(double texels, int level_count);

}  // namespace lambert
