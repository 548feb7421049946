#include "lambert/image/denoise/bilateral.h"

#include "lambert/base/parallel.h"
#include "lambert/image/denoise/exp_of_minus.h"
#include "lambert/image/denoise/guide_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::denoise {
namespace {

/// Planes whose squared differences add up to the exponent of the weight.
using Axes = std::vector<PaddedPlane>;

float half_inverse(float sigma) { return std::sqrt(0.5f) / sigma; }

/// A row of the filtered picture.
void filter_row(const Axes& axes, const std::array<PaddedPlane, 3>& colour, const BilateralSettings& s, int y,
                int height, Colour& result) {
  const int width = result[0].width(), radius = s.window_radius;
  std::vector<float> exponent(static_cast<std::size_t>(width));
  std::array<std::vector<float>, 4> sums;
  for (auto& sum : sums) sum.assign(static_cast<std::size_t>(width), 0);
  for (int dy = std::max(-radius, -y); dy <= std::min(radius, height - 1 - y); ++dy)
    for (int dx = -radius; dx <= radius; ++dx) {
      const int first = std::max(0, -dx), last = std::min(width, width - dx);
      float* __restrict e = exponent.data();
      const float place = static_cast<float>(dx * dx + dy * dy) * half_inverse(s.place) * half_inverse(s.place);
      std::fill(exponent.begin(), exponent.end(), place);
      for (const PaddedPlane& axis : axes) {
        const float* __restrict p = axis.row(y);
        const float* __restrict q = axis.row(y + dy) + dx;
        for (int x = first; x < last; ++x) e[x] += (p[x] - q[x]) * (p[x] - q[x]);
      }
      float* __restrict norm = sums[3].data();
      for (int x = first; x < last; ++x) e[x] = exp_of_minus(e[x]), norm[x] += e[x];
      for (std::size_t c = 0; c < 3; ++c) {
        const float* __restrict q = colour[c].row(y + dy) + dx;
        float* __restrict to = sums[c].data();
        for (int x = first; x < last; ++x) to[x] += e[x] * q[x];
      }
    }
  for (std::size_t c = 0; c < 3; ++c)
    for (int x = 0; x < width; ++x) {
      const auto i = static_cast<std::size_t>(x);
      result[c].at(x, y) = sums[c][i] / sums[3][i];
    }
}

std::array<Colour, 2> bilateral_halves(const std::array<Colour, 2>& halves, const std::vector<Guide>& guides,
                                       const BilateralSettings& settings) {
  const int width = halves[0][0].width(), height = halves[0][0].height(), pad = settings.window_radius;
  Axes guide_axes;
  for (const Guide& guide : guides) {
    const float sigma = guide.kind == GuideKind::albedo   ? settings.albedo
                        : guide.kind == GuideKind::normal ? settings.normal
                                                          : settings.depth;
    for (const Plane& plane : guide.mean) {
      Plane scaled = plane;
      for (float& v : scaled.values()) v *= half_inverse(sigma);
      guide_axes.emplace_back(scaled, pad);
    }
  }
  std::array<Colour, 2> filtered{black(width, height), black(width, height)};
  for (std::size_t half = 0; half < 2; ++half) {
    Axes axes = guide_axes;
    std::array<PaddedPlane, 3> colour;
    for (const Plane& plane : colour_axes(halves[1 - half], 1, settings.colour)) axes.emplace_back(plane, pad);
    for (std::size_t c = 0; c < 3; ++c) colour[c] = PaddedPlane(halves[half][c], pad);
    parallel_for(static_cast<std::size_t>(height), [&](std::size_t y) {
      filter_row(axes, colour, settings, static_cast<int>(y), height, filtered[half]);
    });
  }
  return filtered;
}

}  // namespace

Colour colour_axes(Colour colour, int radius, float sigma) {
  for (Plane& plane : colour) {
    for (float& v : plane.values()) v = std::copysign(std::log1p(std::abs(v)), v);
    plane = box_mean(plane, radius);
    for (float& v : plane.values()) v *= half_inverse(sigma);
  }
  return colour;
}

Colour denoise_bilateral(const NoisyImage& image, const BilateralSettings& settings) {
  const std::vector<Guide> guides = filter_guides(image.guides, 5);
  const Colour albedo = modulation(guides, image.width, image.height);
  const float unit = brightness_unit(image, albedo);
  const std::array<Colour, 2> filtered = bilateral_halves(demodulated(image.halves, albedo, unit), guides, settings);
  Colour result = black(image.width, image.height);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < result[c].values().size(); ++i)
      result[c].values()[i] =
          0.5f * (filtered[0][c].values()[i] + filtered[1][c].values()[i]) * (unit * albedo[c].values()[i]);
  add_filtered_emission(result, image);
  return result;
}

}  // namespace lambert::denoise
