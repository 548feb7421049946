#include "lambert/lab/pixel_format.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::lab {

const std::vector<PixelFormat>& pixel_formats() {
  static const std::vector<PixelFormat> all{
      {.name = "8-bit sRGB (PNG)", .bytes_per_pixel = 3, .file = "light.png", .options = {.depth = Depth::bits8}},
      {.name = "16-bit sRGB (PNG)", .bytes_per_pixel = 6, .file = "light.png", .options = {.depth = Depth::bits16}},
      {.name = "RGBE (Radiance)", .bytes_per_pixel = 4, .file = "light.hdr"},
      {.name = "half (OpenEXR)", .bytes_per_pixel = 6, .file = "light.exr", .options = {.depth = Depth::half}},
      {.name = "float (PFM)", .bytes_per_pixel = 12, .file = "light.pfm"},
  };
  return all;
}

Image round_trip(const Image& image, const PixelFormat& format) {
  return decode_image(encode_image(format.file, image, format.options), format.file);
}

std::vector<OctaveError> octave_errors(const PixelFormat& format, int first, int last, float beside) {
  constexpr int values = 1024;
  const auto exact = [&](int x, int y) { return std::exp2(first + y + (x + 0.5) / values); };
  Image light(values, last - first, rgb_channels());
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < values; ++x) {
      const auto v = static_cast<float>(exact(x, y));
      light.set_rgb(x, y, {v, beside * v, beside * v});
    }
  const Image back = round_trip(light, format);
  std::vector<OctaveError> errors;
  for (int y = 0; y < light.height(); ++y) {
    double worst = 0;
    for (int x = 0; x < values; ++x)
      worst = std::max(worst, std::abs(static_cast<double>(back.at(x, y, 0)) / exact(x, y) - 1));
    errors.push_back({std::exp2(first + y + 0.5), worst});
  }
  return errors;
}

hdr::RadianceRange kept_range(const PixelFormat& format) {
  // From the smallest float, which is not normal, to the largest, with all the bits of a half between.
  constexpr int first = -149, octaves = 128 - first, steps = 1 << 10;
  Image light(steps, octaves, rgb_channels());
  for (int y = 0; y < octaves; ++y)
    for (int x = 0; x < steps; ++x) light.set_rgb(x, y, Rgb(std::ldexp(1 + static_cast<float>(x) / steps, first + y)));
  light.set_rgb(steps - 1, octaves - 1, Rgb(std::numeric_limits<float>::max()));
  return hdr::radiance_range(round_trip(light, format));
}

}  // namespace lambert::lab
