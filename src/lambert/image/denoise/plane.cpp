#include "lambert/image/denoise/plane.h"

#include "lambert/base/parallel.h"

#include <algorithm>

namespace lambert::denoise {

Colour black(int width, int height) { return {Plane(width, height), Plane(width, height), Plane(width, height)}; }

PaddedPlane::PaddedPlane(const Plane& plane, int pad) : pad_(pad), stride_(plane.width() + 2 * pad + 8) {
  values_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(plane.height() + 2 * pad) + 8);
  parallel_for(static_cast<std::size_t>(plane.height() + 2 * pad), [&](std::size_t i) {
    const float* from = plane.row(std::clamp(static_cast<int>(i) - pad, 0, plane.height() - 1));
    float* to = values_.data() + i * static_cast<std::size_t>(stride_);
    std::fill_n(to, pad, from[0]);
    std::copy_n(from, plane.width(), to + pad);
    std::fill_n(to + pad + plane.width(), pad + 8, from[plane.width() - 1]);
  });
}

Plane box_mean(const Plane& plane, int radius) {
  const int width = plane.width(), height = plane.height();
  Plane across(width, height), mean(width, height);
  const auto share = [&](int at, int size) {
    return 1 / static_cast<float>(std::min(at + radius, size - 1) - std::max(at - radius, 0) + 1);
  };
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t i) {
    const int y = static_cast<int>(i);
    const float* from = plane.row(y);
    for (int x = 0; x < width; ++x) {
      float sum = 0;
      for (int s = std::max(x - radius, 0); s <= std::min(x + radius, width - 1); ++s) sum += from[s];
      across.at(x, y) = sum * share(x, width);
    }
  });
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t i) {
    const int y = static_cast<int>(i);
    float* to = mean.row(y);
    for (int s = std::max(y - radius, 0); s <= std::min(y + radius, height - 1); ++s) {
      const float* from = across.row(s);
      for (int x = 0; x < width; ++x) to[x] += from[x];
    }
    const float scale = share(y, height);
    for (int x = 0; x < width; ++x) to[x] *= scale;
  });
  return mean;
}

}  // namespace lambert::denoise
