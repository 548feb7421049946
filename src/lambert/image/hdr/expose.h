#pragma once
/// Photographs of a radiance map, as a camera of known response, noise and bits takes them (row LF-16).

#include "lambert/image/formats/codecs.h"
#include "lambert/image/hdr/noise.h"
#include "lambert/image/hdr/response.h"
#include "lambert/image/image.h"

#include <cstdint>
#include <string>

namespace lambert::hdr {

struct ExposeSettings {
  double exposure = 1;  ///< radiance 1 / exposure just saturates
  SensorNoise noise;
  int bits = 8;            ///< 8 or 16
  std::uint64_t seed = 0;  ///< of the noise
  /// Where the camera looked, in pixels right and down and in radians clockwise about the centre: picture point p shows
  /// what lies at centre + R (p - centre) + move of the map, bilinear, the border repeated.
  Vec2d move{0};
  double turn = 0;
};

/// code = floor((2^bits - 1) f(min(1, L exposure)) + 1/2) per colour channel; NaN and what is below 0 is 0. Alpha is
/// not kept: premultiplied radiance is what the camera sees. `response` should have 65536 levels, of which lesser codes
/// are rounded.
DisplayImage expose(const Image& map, const Response& response, const ExposeSettings& settings);

}  // namespace lambert::hdr
