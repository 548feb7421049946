#pragma once
/// The numbers of a radiance map (rows LF-15, LF-17).

#include "lambert/image/image.h"

#include <cstddef>

namespace lambert::hdr {

struct RadianceRange {
  double max = 0, min_positive = 0;  ///< of the finite values; 0 when there are none above 0
  std::size_t values = 0, zero = 0, negative = 0, not_finite = 0;
  double ratio() const { return min_positive > 0 ? max / min_positive : 1; }
  double stops() const;  ///< log2 of the ratio
};

enum class RangeOf { channels, luminance };
/// Over the colour channels (R, G, B or the first one), each value on its own, or over their luminance.
RadianceRange radiance_range(const Image& image, RangeOf of = RangeOf::channels);

/// By which factor 2^bits equal steps fall short of a range `ratio`: the ratio over 2^bits.
double shortfall(double ratio, int bits);
/// What one of 2^bits equal steps between the ends must span.
double step_size(const RadianceRange& range, int bits);

}  // namespace lambert::hdr
