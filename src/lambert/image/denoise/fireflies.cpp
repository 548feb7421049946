#include "lambert/image/denoise/fireflies.h"

#include "lambert/base/parallel.h"
#include "lambert/base/rgb.h"

#include <algorithm>
#include <utility>

namespace lambert::denoise {
namespace {

constexpr int radius = 2;
constexpr std::size_t rank = 4;

Plane luminance_of(const Colour& c) {
  Plane y(c[0].width(), c[0].height());
  for (std::size_t i = 0; i < y.values().size(); ++i)
    y.values()[i] = luminance({c[0].values()[i], c[1].values()[i], c[2].values()[i]});
  return y;
}

/// The `rank` largest numbers so far, the largest first.
struct Largest {
  std::array<float, rank> values{};
  void add(float v) {
    if (!(v > values.back())) return;
    values.back() = v;
    for (std::size_t i = rank - 1; i > 0 && values[i] > values[i - 1]; --i) std::swap(values[i], values[i - 1]);
  }
};

}  // namespace

void clamp_fireflies(NoisyImage& image, float factor) {
  const std::array<Plane, 2> y{luminance_of(image.halves[0]), luminance_of(image.halves[1])};
  const Plane variance = luminance_of(image.variance);
  parallel_for(static_cast<std::size_t>(image.height), [&](std::size_t i) {
    const int row = static_cast<int>(i);
    for (int x = 0; x < image.width; ++x) {
      std::array<float, 2> scale{1, 1};
      const float mean = 0.5f * (y[0].at(x, row) + y[1].at(x, row));
      for (std::size_t half = 0; half < 2; ++half) {
        const float own = y[half].at(x, row), other = y[1 - half].at(x, row);
        if (!(own > 0)) continue;
        const bool trusted = image.measured_halves ? own <= factor * other : variance.at(x, row) < 0.1f * mean * mean;
        if (trusted) continue;
        Largest largest;
        for (int t = std::max(row - radius, 0); t <= std::min(row + radius, image.height - 1); ++t)
          for (int s = std::max(x - radius, 0); s <= std::min(x + radius, image.width - 1); ++s)
            if (s != x || t != row) largest.add(y[0].at(s, t)), largest.add(y[1].at(s, t));
        const float limit = factor * std::max(largest.values.back(), image.measured_halves ? other : 0.0f);
        if (own > limit) scale[half] = limit / own;
      }
      if (scale[0] == 1 && scale[1] == 1) continue;
      const float after = 0.5f * (scale[0] * y[0].at(x, row) + scale[1] * y[1].at(x, row)), ratio = after / mean;
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t half = 0; half < 2; ++half) image.halves[half][c].at(x, row) *= scale[half];
        image.variance[c].at(x, row) *= ratio * ratio;
      }
    }
  });
}

}  // namespace lambert::denoise
