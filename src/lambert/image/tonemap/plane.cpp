#include "lambert/image/tonemap/plane.h"

#include <cmath>

namespace lambert::tone {
namespace {

/// One side of the kernel, the middle first; the whole sums to one.
std::vector<float> half_kernel(float sigma) {
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  std::vector<float> weights;
  double sum = 0;
  for (int i = 0; i <= radius; ++i) {
    const double u = i / static_cast<double>(sigma), w = std::exp(-0.5 * u * u);
    weights.push_back(static_cast<float>(w));
    sum += i == 0 ? w : 2 * w;
  }
  for (float& w : weights) w = static_cast<float>(static_cast<double>(w) / sum);
  return weights;
}

/// to[x] += weight (a[x] + b[x])
void add_pair(float* to, const float* a, const float* b, float weight, std::size_t count) {
  for (std::size_t x = 0; x < count; ++x) to[x] += weight * (a[x] + b[x]);
}

}  // namespace

Plane gaussian_blur(const Plane& plane, float sigma) {
  if (!(sigma > 0) || plane.values.empty()) return plane;
  const std::vector<float> kernel = half_kernel(sigma);
  const std::size_t radius = kernel.size() - 1, width = static_cast<std::size_t>(plane.width);
  Plane across(plane.width, plane.height), out(plane.width, plane.height);
  for_row_blocks(plane.height, [&](std::size_t, int first, int last) {
    std::vector<float> padded(width + 2 * radius);
    for (int y = first; y < last; ++y) {
      const auto from = plane.row(y);
      const auto to = across.row(y);
      std::fill_n(padded.begin(), radius, from.front());
      std::copy(from.begin(), from.end(), padded.begin() + static_cast<std::ptrdiff_t>(radius));
      std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, from.back());
      for (std::size_t x = 0; x < width; ++x) to[x] = kernel[0] * from[x];
      for (std::size_t i = 1; i <= radius; ++i)
        add_pair(to.data(), padded.data() + radius - i, padded.data() + radius + i, kernel[i], width);
    }
  });
  for_rows(plane.height, [&](int y) {
    const auto from = across.row(y);
    const auto to = out.row(y);
    for (std::size_t x = 0; x < width; ++x) to[x] = kernel[0] * from[x];
    for (std::size_t i = 1; i <= radius; ++i) {
      const int d = static_cast<int>(std::min<std::size_t>(i, static_cast<std::size_t>(plane.height)));
      add_pair(to.data(), across.row(std::max(y - d, 0)).data(), across.row(std::min(y + d, plane.height - 1)).data(),
               kernel[i], width);
    }
  });
  return out;
}

}  // namespace lambert::tone
