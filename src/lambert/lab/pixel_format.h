#pragma once
/// What image files keep of light, found by writing and reading them.

#include "lambert/image/hdr/range.h"
#include "lambert/image/io.h"

#include <string>
#include <vector>

namespace lambert::lab {

struct PixelFormat {
  std::string name;
  int bytes_per_pixel = 0;  ///< of three channels, before any compression
  std::string file;         ///< a name whose extension chooses the format
  WriteOptions options = {};
};

/// 8- and 16-bit sRGB (PNG), RGBE, half (OpenEXR) and float (PFM).
const std::vector<PixelFormat>& pixel_formats();

/// What is read of the file that was written, all in memory.
Image round_trip(const Image& image, const PixelFormat& format);

/// Light of [2^e, 2^(e+1)) and the worst relative error that it comes back with.
struct OctaveError {
  double radiance = 0;  ///< the middle of the octave
  double error = 0;
};
/// Of 1024 values in each octave from 2^first to 2^last, told from the exact number, not from its float. They are in
/// one channel; the others are `beside` times as bright.
std::vector<OctaveError> octave_errors(const PixelFormat& format, int first, int last, float beside = 1);

/// The largest and the smallest positive number that come back of any grey.
hdr::RadianceRange kept_range(const PixelFormat& format);

}  // namespace lambert::lab
