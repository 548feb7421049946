#include "lambert/image/denoise/noise_level.h"

#include "lambert/base/hash.h"
#include "lambert/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambert::denoise {
namespace {

constexpr int cell = 4, reach = 8;

/// Of the noise of one plane, on a grid of cells.
Plane measured_variance(const Plane& plane) {
  const PaddedPlane padded(plane, 1);
  Plane response(plane.width(), plane.height());
  for (int y = 0; y < plane.height(); ++y) {
    const float *a = padded.row(y - 1), *b = padded.row(y), *c = padded.row(y + 1);
    for (int x = 0; x < plane.width(); ++x) {
      const auto across = [&](const float* r) { return r[x - 1] - 2 * r[x] + r[x + 1]; };
      response.at(x, y) = std::abs(across(a) - 2 * across(b) + across(c));
    }
  }
  Plane grid((plane.width() + cell - 1) / cell, (plane.height() + cell - 1) / cell);
  parallel_for(static_cast<std::size_t>(grid.height()), [&](std::size_t row) {
    const int gy = static_cast<int>(row);
    std::vector<float> around;
    for (int gx = 0; gx < grid.width(); ++gx) {
      around.clear();
      const int x = gx * cell + cell / 2, y = gy * cell + cell / 2;
      for (int t = std::max(y - reach, 0); t <= std::min(y + reach, plane.height() - 1); ++t)
        for (int s = std::max(x - reach, 0); s <= std::min(x + reach, plane.width() - 1); ++s)
          around.push_back(response.at(s, t));
      const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
      std::nth_element(around.begin(), middle, around.end());
      constexpr float median_of_normal = 0.67449f, norm = 6;
      const float sigma = *middle / (median_of_normal * norm);
      grid.at(gx, gy) = sigma * sigma;
    }
  });
  return grid;
}

}  // namespace

void fill_unknown_variance(NoisyImage& image) {
  for (std::size_t c = 0; c < 3; ++c) {
    Plane& variance = image.variance[c];
    const auto known = [](float v) { return std::isfinite(v); };
    if (!std::all_of(variance.values().begin(), variance.values().end(), known)) {
      Plane mean = image.halves[0][c];
      for (std::size_t i = 0; i < mean.values().size(); ++i)
        mean.values()[i] = 0.5f * (mean.values()[i] + image.halves[1][c].values()[i]);
      const Plane grid = measured_variance(mean);
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
          if (!known(variance.at(x, y))) variance.at(x, y) = grid.at(x / cell, y / cell);
    }
    for (float& v : variance.values()) v = std::clamp(v, 0.0f, 1e30f);
  }
}

void fit_variance_to_halves(NoisyImage& image) {
  constexpr int radius = 2;
  Plane ratio(image.width, image.height);
  for (std::size_t i = 0; i < ratio.values().size(); ++i) {
    float seen = 0, said = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float d = image.halves[0][c].values()[i] - image.halves[1][c].values()[i];
      seen += 0.25f * d * d;
      said += image.variance[c].values()[i];
    }
    ratio.values()[i] = said > 0 ? std::min(seen / said, 4.0f) : 1.0f;
  }
  ratio = box_mean(ratio, radius);
  for (Plane& plane : image.variance)
    for (std::size_t i = 0; i < ratio.values().size(); ++i) plane.values()[i] *= std::min(1.0f, ratio.values()[i]);
}

void split(NoisyImage& image) {
  parallel_for(static_cast<std::size_t>(image.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint64_t h = hash_values(x, y, static_cast<int>(c));
        const float u = hash_to_float(h), v = hash_to_float(mix_bits(h));
        const float normal = std::sqrt(-2 * std::log(1 - u)) * std::cos(2 * std::numbers::pi_v<float> * v);
        const float offset = std::sqrt(image.variance[c].at(x, y)) * normal;
        image.halves[0][c].at(x, y) += offset;
        image.halves[1][c].at(x, y) -= offset;
      }
  });
}

}  // namespace lambert::denoise
