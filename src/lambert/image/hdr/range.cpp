#include "lambert/image/hdr/range.h"

#include <algorithm>
#include <cmath>

namespace lambert::hdr {

double RadianceRange::stops() const { return std::log2(ratio()); }

RadianceRange radiance_range(const Image& image, RangeOf of) {
  RadianceRange r;
  const auto add = [&r](float value) {
    ++r.values;
    if (!std::isfinite(value)) {
      ++r.not_finite;
    } else if (value > 0) {
      const auto v = static_cast<double>(value);
      r.max = std::max(r.max, v);
      r.min_positive = r.min_positive > 0 ? std::min(r.min_positive, v) : v;
    } else {
      ++(value < 0 ? r.negative : r.zero);
    }
  };
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Rgb c = image.rgb(x, y);
      if (of == RangeOf::luminance)
        add(image.has_colour() ? luminance(c) : c.r);
      else if (image.has_colour())
        add(c.r), add(c.g), add(c.b);
      else
        add(c.r);
    }
  return r;
}

double shortfall(double ratio, int bits) { return ratio / std::exp2(bits); }

double step_size(const RadianceRange& range, int bits) { return (range.max - range.min_positive) / std::exp2(bits); }

}  // namespace lambert::hdr
