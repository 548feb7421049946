#include "lambert/image/compare/ssim.h"

#include "lambert/base/error.h"

#include <array>
#include <cmath>
#include <numeric>

namespace lambert::compare {
namespace {

Plane luminance_plane(const Image& image) {
  Plane plane(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const float value = luminance(image.rgb(x, y));
      plane.row(y)[static_cast<std::size_t>(x)] = std::isfinite(value) ? value : 0.0f;
    }
  return plane;
}

Plane product(const Plane& a, const Plane& b) {
  Plane result(a.width, a.height);
  for (std::size_t i = 0; i < a.values.size(); ++i) result.values[i] = a.values[i] * b.values[i];
  return result;
}

/// 11 x 11 weights of the deviation 1.5.
Plane window_mean(const Plane& plane) {
  std::array<double, 11> window;
  for (int i = 0; i < 11; ++i) window[static_cast<std::size_t>(i)] = std::exp(-(i - 5) * (i - 5) / (2 * 1.5 * 1.5));
  const double sum = std::accumulate(window.begin(), window.end(), 0.0);
  for (double& w : window) w /= sum;
  return filtered(plane, window, window);
}

}  // namespace

Similarity ssim(const Image& image_a, const Image& image_b) {
  if (image_a.width() != image_b.width() || image_a.height() != image_b.height()) throw Error("the sizes differ");
  const Plane a = luminance_plane(image_a), b = luminance_plane(image_b);
  const Plane mean_a = window_mean(a), mean_b = window_mean(b);
  const Plane aa = window_mean(product(a, a)), bb = window_mean(product(b, b)), ab = window_mean(product(a, b));
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  Similarity result{.mean = 0, .map = Plane(a.width, a.height)};
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double ma = static_cast<double>(mean_a.values[i]), mb = static_cast<double>(mean_b.values[i]);
    const double va = static_cast<double>(aa.values[i]) - ma * ma, vb = static_cast<double>(bb.values[i]) - mb * mb;
    const double covariance = static_cast<double>(ab.values[i]) - ma * mb;
    const double s = (2 * ma * mb + c1) * (2 * covariance + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
    result.map.values[i] = static_cast<float>(s);
    result.mean += s;
  }
  result.mean /= static_cast<double>(a.values.size());
  return result;
}

}  // namespace lambert::compare
