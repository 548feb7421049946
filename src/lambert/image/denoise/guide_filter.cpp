#include "lambert/image/denoise/guide_filter.h"

#include "lambert/image/denoise/nlm.h"

#include <algorithm>
#include <cmath>

namespace lambert::denoise {
namespace {

bool is_zero(const Plane& plane) {
  return std::all_of(plane.values().begin(), plane.values().end(), [](float v) { return v == 0; });
}

}  // namespace

std::vector<Guide> filter_guides(const std::vector<Guide>& guides, int window_radius) {
  std::vector<Guide> filtered;
  for (const Guide& guide : guides) {
    Guide g = guide;
    if (g.kind == GuideKind::depth) {
      double sum = 0;
      for (const float v : g.mean[0].values()) sum += static_cast<double>(std::abs(v));
      const auto unit = static_cast<float>(sum / static_cast<double>(g.mean[0].values().size()));
      if (unit > 0) {
        for (float& v : g.mean[0].values()) v /= unit;
        for (float& v : g.variance[0].values()) v /= unit * unit;
      }
    }
    if (!std::all_of(g.variance.begin(), g.variance.end(), is_zero))
      g.mean = nl_means(g.mean, g.mean, g.variance, {.window_radius = window_radius, .patch_radius = 3, .k = 1});
    filtered.push_back(std::move(g));
  }
  return filtered;
}

Colour modulation(const std::vector<Guide>& filtered, int width, int height) {
  Colour albedo{Plane(width, height, 1), Plane(width, height, 1), Plane(width, height, 1)};
  for (const Guide& guide : filtered)
    if (guide.kind == GuideKind::albedo)
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < albedo[c].values().size(); ++i)
          albedo[c].values()[i] = std::max(guide.mean[c].values()[i], 0.01f);
  return albedo;
}

std::array<Colour, 2> demodulated(const std::array<Colour, 2>& halves, const Colour& albedo, float unit) {
  std::array<Colour, 2> result = halves;
  for (Colour& half : result)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < half[c].values().size(); ++i) half[c].values()[i] /= unit * albedo[c].values()[i];
  return result;
}

void add_filtered_emission(Colour& to, const NoisyImage& image) {
  if (std::all_of(image.emission.begin(), image.emission.end(), is_zero)) return;
  const bool exact = std::all_of(image.emission_variance.begin(), image.emission_variance.end(), is_zero);
  std::vector<Plane> filtered(image.emission.begin(), image.emission.end());
  if (!exact)
    filtered = nl_means(image.emission, image.emission, image.emission_variance,
                        {.window_radius = 8, .patch_radius = 2, .k = 0.5f});
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < filtered[c].values().size(); ++i) to[c].values()[i] += filtered[c].values()[i];
}

float brightness_unit(const NoisyImage& image, const Colour& albedo) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < albedo[c].values().size(); ++i)
      sum += std::abs(static_cast<double>(image.halves[0][c].values()[i] + image.halves[1][c].values()[i]) /
                      static_cast<double>(albedo[c].values()[i]));
  const double mean = sum / 6 / static_cast<double>(albedo[0].values().size());
  return mean > 1e-30 && mean < 1e30 ? static_cast<float>(std::exp2(std::round(std::log2(mean)))) : 1.0f;
}

}  // namespace lambert::denoise
