#include "lambert/image/filter/blur.h"

#include "lambert/base/error.h"
#include "lambert/image/filter/separable.h"
#include "lambert/image/filter/sliding_window.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lambert {
namespace {

constexpr double reach = 5;  // deviations after which a Gaussian is cut off

Image placed_as(Image image, const Image& original) {
  const Window data = original.data_window();
  image.place({data.x, data.y}, original.display_window());
  return image;
}

Taps gaussian_taps(double sigma, int n, EdgeMode edge) {
  if (sigma == 0) return identity_taps(n);
  const int radius = static_cast<int>(std::ceil(reach * sigma));
  std::vector<double> weights;
  double sum = 0;
  for (int k = -radius; k <= radius; ++k) {
    weights.push_back(gaussian_kernel(k, sigma));
    sum += weights.back();
  }
  for (double& w : weights) w /= sum;
  return convolution_taps(weights, n, edge);
}

/// To the coarser grid and back. Both Gaussians have a deviation of 1.25 coarse pixels: a frequency f (in cycles per
/// coarse pixel) that the grid takes for 1 - f passes both with exp(-2π² 1.25² (f² + (1 - f)²)) <= 2e-7.
struct Decimation {
  Taps there, back;
};
Decimation decimation(double sigma, int n, EdgeMode edge) {
  if (sigma == 0) return {identity_taps(n), identity_taps(n)};
  constexpr double coarse = 1.25;
  const double step = sigma / (coarse * std::numbers::sqrt2);
  const Kernel kernel({.kind = FilterKind::gaussian,
                       .radius = Vec2(static_cast<float>(reach * coarse)),
                       .sigma = static_cast<float>(coarse),
                       .truncated = true},
                      Kernel::Axis::x);
  // Beyond the image's ends as far as the second kernel reads.
  const int margin = static_cast<int>(std::ceil(reach * coarse)) + 1;
  const int size = static_cast<int>(std::ceil(n / step)) + 2 * margin;
  return {resampling_taps(kernel, {.in = n, .out = size, .scale = step, .offset = -static_cast<double>(margin)}, edge),
          resampling_taps(kernel, {.in = size, .out = n, .scale = 1 / step, .offset = margin * step}, EdgeMode::clamp)};
}

}  // namespace

Image gaussian_blurred(const Image& image, Vec2 sigma, EdgeMode edge, GaussianMethod method) {
  constexpr float most = 65536;
  if (!(sigma.x >= 0 && sigma.y >= 0 && sigma.x <= most && sigma.y <= most))
    throw Error("a blur's deviation must be from 0 to 65536 pixels");
  const double x = static_cast<double>(sigma.x), y = static_cast<double>(sigma.y);
  const double least = method == GaussianMethod::decimated ? 2 : 4;
  const auto direct = [&](double s) { return method == GaussianMethod::direct || s < least; };
  const auto one_way = [&](double s, int n) { return direct(s) ? gaussian_taps(s, n, edge) : identity_taps(n); };
  Image out;
  if (!direct(x) || !direct(y)) {
    const Decimation columns = decimation(direct(x) ? 0 : x, image.width(), edge);
    const Decimation rows = decimation(direct(y) ? 0 : y, image.height(), edge);
    out = separably_filtered(separably_filtered(image, columns.there, rows.there), columns.back, rows.back);
  }
  if ((direct(x) && x > 0) || (direct(y) && y > 0))
    out = separably_filtered(out.empty() ? image : out, one_way(x, image.width()), one_way(y, image.height()));
  return out.empty() ? image : placed_as(std::move(out), image);
}

Image box_blurred(const Image& image, Vec2i radius, EdgeMode edge) {
  Image out = slid(image, radius, WindowOperation::sum, edge);
  const double count = (2.0 * radius.x + 1) * (2.0 * radius.y + 1);
  const auto share = static_cast<float>(1 / count);
  for (float& v : out.pixels()) v *= share;
  return out;
}

Image bartlett_blurred(const Image& image, Vec2i radius, EdgeMode edge) {
  constexpr int most = 4096;
  if (radius.x < 0 || radius.y < 0 || radius.x > most || radius.y > most)
    throw Error("a Bartlett kernel's radius must be from 0 to " + std::to_string(most));
  const auto taps = [&](int r, int n) {
    std::vector<double> weights;
    for (int k = -r; k <= r; ++k) weights.push_back((r + 1.0 - std::abs(k)) / ((r + 1.0) * (r + 1.0)));
    return convolution_taps(weights, n, edge);
  };
  return placed_as(separably_filtered(image, taps(radius.x, image.width()), taps(radius.y, image.height())), image);
}

}  // namespace lambert
