#pragma once
/// How far two images lie apart, pixel by pixel.

#include "lambert/image/image.h"

#include <cstddef>
#include <string>
#include <vector>

namespace lambert::compare {

/// A value is a channel of a pixel. Two NaN, and two equal infinities, are equal; any other pair with a value that is
/// not finite has no difference: it is counted in `incomparable`, fails every threshold and enters no mean.
struct Errors {
  std::size_t values = 0, incomparable = 0;
  double mean = 0;            ///< of |a - b|
  double bias = 0;            ///< mean of a - b
  double mse = 0;             ///< mean of (a - b)²
  double relative_mse = 0;    ///< mean of (a - b)² / (b² + 0.01): b is the reference (Rousselle et al. 2011)
  double trimmed_mse = 0;     ///< the same without the thousandth of the values where it is largest
  double largest = 0;         ///< |a - b|, infinite when a pair is incomparable
  int x = 0, y = 0;           ///< the pixel of `largest`
  std::string channel;        ///< and its channel; empty when the images are equal
  double largest_value = 0;   ///< of |b|
  std::vector<float> pixels;  ///< per pixel, rows from the top: the largest |a - b| of its channels

  /// 20 log10(peak / rms), in dB; infinite for equal images.
  double psnr(double peak) const;
  /// How many pixels differ by more than `threshold`.
  std::size_t pixels_over(double threshold) const;
};

/// Over all channels. Throws Error unless the images have equal sizes and channels.
Errors errors_of(const Image& a, const Image& b);

/// a - b, per channel. Throws as errors_of does.
Image difference(const Image& a, const Image& b);

}  // namespace lambert::compare
