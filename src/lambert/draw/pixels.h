#pragma once
#include "lambert/draw/drawing.h"

#include "lambert/image/image.h"

#include <cstdint>
#include <vector>

namespace lambert::draw {

/// sRGB pixels without alpha, row 0 at the top.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The drawing on white, each pixel the mean of 4 x 4 sample points. Marks with a coordinate that is not finite are
/// left out. At most 8192 pixels a side, where larger drawings end.
Pixels rasterised(const Drawing& drawing);

/// The same in linear light, channels R, G, B.
Image to_image(const Pixels& pixels);

}  // namespace lambert::draw
