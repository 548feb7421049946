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

/// How much of candidate 1 each pixel takes, from 0 to 1.
Plane choose(const std::array<Plane, 2>& error, int radius) {
  Plane gain = error[0];
  for (std::size_t i = 0; i < gain.values().size(); ++i) gain.values()[i] -= error[1].values()[i];
  Plane share = box_mean(gain, radius);
  for (float& v : share.values()) v = v > 0 ? 1.0f : 0.0f;
  return box_mean(share, radius);
}

}  // namespace

Colour denoise_nfor(const NoisyImage& image, const NforSettings& settings) {
  const std::vector<Guide> guides = filter_guides(image.guides, settings.feature_window_radius);
  std::vector<Plane> features;
  for (const Guide& guide : guides) features.insert(features.end(), guide.mean.begin(), guide.mean.end());

  const Colour albedo = modulation(guides, image.width, image.height);
  std::array<Colour, 2> halves = image.halves;
  Colour variance = image.variance;
  const float unit = brightness_unit(image, albedo);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < variance[c].values().size(); ++i) {
      const float factor = 1 / (unit * albedo[c].values()[i]);
      halves[0][c].values()[i] *= factor, halves[1][c].values()[i] *= factor;
      variance[c].values()[i] *= 2 * factor * factor;  // of one half
    }

  std::array<Candidates, 2> by_half;
  for (std::size_t half = 0; half < 2; ++half)
    by_half[half] = regress(halves[half], halves[1 - half], variance, features, settings.regression);
  std::array<std::array<Colour, 2>, 2> filtered;
  std::array<Plane, 2> error;
  for (std::size_t k = 0; k < 2; ++k) {
    filtered[k] = {by_half[0][k], by_half[1][k]};
    error[k] = error_of(filtered[k], halves);
  }
  const Plane share = choose(error, settings.selection_radius);
  Colour result = black(image.width, image.height);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < share.values().size(); ++i) {
      const float s = share.values()[i];
      const auto mean = [&](std::size_t k) {
        return 0.5f * (filtered[k][0][c].values()[i] + filtered[k][1][c].values()[i]);
      };
      result[c].values()[i] = ((1 - s) * mean(0) + s * mean(1)) * albedo[c].values()[i] * unit;
    }
  add_filtered_emission(result, image);
  return result;
}

}  // namespace lambert::denoise
