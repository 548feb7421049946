#include "lambert/image/denoise/nfor.h"

#include "lambert/base/parallel.h"
#include "lambert/image/denoise/guide_filter.h"

#include <algorithm>
#include <cmath>

namespace lambert::denoise {
namespace {

/// The error of the mean of two filtered halves up to what is the same for all candidates, relative to the brightness.
Plane error_of(const std::array<Colour, 2>& filtered, const std::array<Colour, 2>& halves) {
  const auto& [fa, fb] = filtered;
  const auto& [a, b] = halves;
  Plane error(a[0].width(), a[0].height());
  for (std::size_t i = 0; i < error.values().size(); ++i) {
    float sum = 0, brightness = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float va = fa[c].values()[i], vb = fb[c].values()[i];
      const float to_b = va - b[c].values()[i], to_a = vb - a[c].values()[i], between = va - vb;
      sum += 0.5f * (to_b * to_b + to_a * to_a) - 0.25f * between * between;
      brightness += 0.5f * (va + vb);
    }
    error.values()[i] = sum / (brightness * brightness + 1e-2f);
  }
  return error;
}

/// How much of each candidate a pixel takes; they sum to 1.
std::array<Plane, candidate_count> choose(std::array<Plane, candidate_count> error, int radius) {
  for (Plane& e : error) e = box_mean(e, radius);
  std::array<Plane, candidate_count> share;
  share.fill(Plane(error[0].width(), error[0].height()));
  for (std::size_t i = 0; i < error[0].values().size(); ++i) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < candidate_count; ++k)
      if (error[k].values()[i] < error[best].values()[i]) best = k;
    share[best].values()[i] = 1;
  }
  for (Plane& s : share) s = box_mean(s, radius);
  return share;
}

}  // namespace

Colour denoise_nfor(const NoisyImage& image, const NforSettings& settings) {
  const std::vector<Guide> guides = filter_guides(image.guides, settings.feature_window_radius);
  std::vector<Plane> features;
  for (const Guide& guide : guides) features.insert(features.end(), guide.mean.begin(), guide.mean.end());

  const Colour albedo = modulation(guides, image.width, image.height);
  const float unit = brightness_unit(image, albedo);
  const std::array<Colour, 2> halves = demodulated(image.halves, albedo, unit);
  Colour variance = image.variance;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < variance[c].values().size(); ++i) {
      const float factor = 1 / (unit * albedo[c].values()[i]);
      variance[c].values()[i] *= 2 * factor * factor;  // of one half
    }

  std::array<Candidates, 2> by_half;
  for (std::size_t half = 0; half < 2; ++half)
    by_half[half] = regress(halves[half], halves[1 - half], variance, features, settings.regression);
  std::array<std::array<Colour, 2>, candidate_count> filtered;
  std::array<Plane, candidate_count> error;
  for (std::size_t k = 0; k < candidate_count; ++k) {
    filtered[k] = {by_half[0][k], by_half[1][k]};
    error[k] = error_of(filtered[k], halves);
  }
  const std::array<Plane, candidate_count> share = choose(error, settings.selection_radius);
  Colour result = black(image.width, image.height);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < result[c].values().size(); ++i) {
      float sum = 0;
      for (std::size_t k = 0; k < candidate_count; ++k)
        sum += share[k].values()[i] * 0.5f * (filtered[k][0][c].values()[i] + filtered[k][1][c].values()[i]);
      result[c].values()[i] = sum * albedo[c].values()[i] * unit;
    }
  add_filtered_emission(result, image);
  return result;
}

}  // namespace lambert::denoise
