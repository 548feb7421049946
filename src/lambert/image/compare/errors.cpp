#include "lambert/image/compare/errors.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::compare {
namespace {

std::string size_text(const Image& image) {
  return std::to_string(image.width()) + "x" + std::to_string(image.height());
}

void expect_alike(const Image& a, const Image& b) {
  if (a.width() != b.width() || a.height() != b.height())
    throw Error("the sizes differ: " + size_text(a) + " and " + size_text(b));
  if (a.channels() != b.channels()) throw Error("the channels differ");
}

struct RowErrors {
  double absolute = 0, plain = 0, square = 0, relative = 0;
  double largest = 0, largest_value = 0;
  std::size_t incomparable = 0, where = 0;
};

RowErrors row_errors(std::span<const float> a, std::span<const float> b, std::size_t channels, float* relative,
                     float* pixels) {
  RowErrors sum;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double va = static_cast<double>(a[i]), vb = static_cast<double>(b[i]);
    double apart = 0;
    if (va == vb || (std::isnan(va) && std::isnan(vb))) {
      relative[i] = 0;
    } else if (!std::isfinite(va) || !std::isfinite(vb)) {
      apart = std::numeric_limits<double>::infinity();
      relative[i] = 0;
      ++sum.incomparable;
    } else {
      const double d = va - vb;
      apart = std::abs(d);
      sum.absolute += apart;
      sum.plain += d;
      sum.square += d * d;
      const double r = d * d / (vb * vb + 0.01);
      sum.relative += r;
      relative[i] = static_cast<float>(r);
    }
    if (std::isfinite(vb)) sum.largest_value = std::max(sum.largest_value, std::abs(vb));
    if (apart > sum.largest) sum.largest = apart, sum.where = i;
    float& pixel = pixels[i / channels];
    pixel = std::max(pixel, static_cast<float>(apart));
  }
  return sum;
}

}  // namespace

double Errors::psnr(double peak) const { return 20 * std::log10(peak) - 10 * std::log10(mse); }

std::size_t Errors::pixels_over(double threshold) const {
  return static_cast<std::size_t>(
      std::count_if(pixels.begin(), pixels.end(), [&](float e) { return static_cast<double>(e) > threshold; }));
}

Errors errors_of(const Image& a, const Image& b) {
  expect_alike(a, b);
  const auto height = static_cast<std::size_t>(a.height()), width = static_cast<std::size_t>(a.width());
  const std::size_t channels = a.channel_count();
  std::vector<RowErrors> rows(height);
  std::vector<float> relative(a.pixels().size());
  Errors e;
  e.pixels.resize(width * height);
  parallel_for(height, [&](std::size_t y) {
    rows[y] = row_errors(a.row(static_cast<int>(y)), b.row(static_cast<int>(y)), channels,
                         &relative[y * width * channels], &e.pixels[y * width]);
  });
  for (std::size_t y = 0; y < height; ++y) {
    const RowErrors& row = rows[y];
    e.incomparable += row.incomparable;
    e.mean += row.absolute, e.bias += row.plain, e.mse += row.square, e.relative_mse += row.relative;
    e.largest_value = std::max(e.largest_value, row.largest_value);
    if (row.largest > e.largest) {
      e.largest = row.largest;
      e.x = static_cast<int>(row.where / channels), e.y = static_cast<int>(y);
      e.channel = a.channels()[row.where % channels];
    }
  }
  e.values = a.pixels().size();
  const auto compared = static_cast<double>(std::max<std::size_t>(1, e.values - e.incomparable));
  e.mean /= compared, e.bias /= compared, e.mse /= compared, e.relative_mse /= compared;

  const std::size_t kept = relative.size() - relative.size() / 1000;
  std::nth_element(relative.begin(), relative.begin() + static_cast<std::ptrdiff_t>(kept - 1), relative.end());
  // Sorted before they are added: nth_element leaves the order open.
  std::sort(relative.begin(), relative.begin() + static_cast<std::ptrdiff_t>(kept));
  for (std::size_t i = 0; i < kept; ++i) e.trimmed_mse += static_cast<double>(relative[i]);
  e.trimmed_mse /= static_cast<double>(kept);
  return e;
}

Image difference(const Image& a, const Image& b) {
  expect_alike(a, b);
  Image result(a.width(), a.height(), a.channels());
  std::transform(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), result.pixels().begin(),
                 [](float va, float vb) { return va == vb ? 0.0f : va - vb; });
  return result;
}

}  // namespace lambert::compare
