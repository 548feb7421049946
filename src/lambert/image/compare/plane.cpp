#include "lambert/image/compare/plane.h"

#include "lambert/base/parallel.h"

#include <algorithm>

namespace lambert::compare {

Plane filtered(const Plane& plane, std::span<const float> across, std::span<const float> down) {
  const int rx = static_cast<int>(across.size() / 2), ry = static_cast<int>(down.size() / 2);
  const auto height = static_cast<std::size_t>(plane.height);
  Plane middle(plane.width, plane.height), result(plane.width, plane.height);
  parallel_for(height, [&](std::size_t i) {
    const int y = static_cast<int>(i);
    const auto in = plane.row(y);
    std::vector<float> padded(in.size() + 2 * static_cast<std::size_t>(rx));
    std::fill_n(padded.begin(), rx, in.front());
    std::copy(in.begin(), in.end(), padded.begin() + rx);
    std::fill_n(padded.end() - rx, rx, in.back());
    const auto out = middle.row(y);
    for (std::size_t k = 0; k < across.size(); ++k)
      for (std::size_t x = 0; x < out.size(); ++x) out[x] += across[k] * padded[x + k];
  });
  parallel_for(height, [&](std::size_t i) {
    const int y = static_cast<int>(i);
    const auto out = result.row(y);
    for (int k = -ry; k <= ry; ++k) {
      const auto in = middle.row(std::clamp(y + k, 0, plane.height - 1));
      const float weight = down[static_cast<std::size_t>(k + ry)];
      for (std::size_t x = 0; x < out.size(); ++x) out[x] += weight * in[x];
    }
  });
  return result;
}

}  // namespace lambert::compare
