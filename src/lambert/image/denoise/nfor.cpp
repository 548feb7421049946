#include "lambert/image/denoise/nfor.h"

#include "lambert/base/parallel.h"
#include "lambert/image/denoise/guide_filter.h"

#include <algorithm>
#include <cmath>

namespace lambert::denoise {
namespace {

using Halves = std::array<Colour, 2>;

/// Mean products of errors, up to what is the same for all of them, and the variance of a half; relative to brightness.
struct Errors {
  Plane uu, uv, vv, noise;
};

Errors errors_of(const Halves& u, const Halves& v, const Halves& halves, const Colour& variance, int radius) {
  const int width = variance[0].width(), height = variance[0].height();
  Errors e{Plane(width, height), Plane(width, height), Plane(width, height), Plane(width, height)};
  for (std::size_t i = 0; i < e.uu.values().size(); ++i) {
    float uu = 0, uv = 0, vv = 0, noise = 0, brightness = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto at = [&](const Halves& of, std::size_t half) { return of[half][c].values()[i]; };
      for (std::size_t half = 0; half < 2; ++half) {
        const float du = at(u, half) - at(halves, 1 - half), dv = at(v, half) - at(halves, 1 - half);
        uu += 0.5f * du * du, uv += 0.5f * du * dv, vv += 0.5f * dv * dv;
      }
      const float between_u = at(u, 0) - at(u, 1), between_v = at(v, 0) - at(v, 1);
      uu -= 0.25f * between_u * between_u, uv -= 0.25f * between_u * between_v, vv -= 0.25f * between_v * between_v;
      noise += variance[c].values()[i];
      brightness += 0.5f * (at(u, 0) + at(u, 1));
    }
    const float scale = 1 / (brightness * brightness + 1e-2f);
    e.uu.values()[i] = uu * scale, e.uv.values()[i] = uv * scale, e.vv.values()[i] = vv * scale;
    e.noise.values()[i] = noise * scale;
  }
  for (Plane* plane : {&e.uu, &e.uv, &e.vv, &e.noise}) *plane = box_mean(*plane, radius);
  return e;
}

/// The share of v beside u.
Plane blend(const Errors& e, int radius) {
  constexpr float ridge = 0.02f;
  Plane share(e.uu.width(), e.uu.height());
  for (std::size_t i = 0; i < share.values().size(); ++i) {
    const float uu = e.uu.values()[i], uv = e.uv.values()[i], vv = e.vv.values()[i];
    share.values()[i] =
        std::clamp((uu - uv) / (std::max(0.0f, uu - 2 * uv + vv) + ridge * e.noise.values()[i] + 1e-20f), 0.0f, 1.0f);
  }
  return box_mean(share, radius);
}

}  // namespace

Colour denoise_nfor(const NoisyImage& image, const NforSettings& settings, const FractionSink& progress) {
  const std::vector<Guide> guides = filter_guides(image.guides, settings.feature_window_radius);
  std::vector<Plane> features;
  for (const Guide& guide : guides) features.insert(features.end(), guide.mean.begin(), guide.mean.end());

  const Colour albedo = modulation(guides, image.width, image.height);
  const float unit = brightness_unit(image, albedo);
  const Halves halves = demodulated(image.halves, albedo, unit);
  Colour variance = image.variance;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < variance[c].values().size(); ++i) {
      const float factor = 1 / (unit * albedo[c].values()[i]);
      variance[c].values()[i] *= 2 * factor * factor;  // of one half
    }

  std::array<Candidates, 2> by_half;
  for (std::size_t half = 0; half < 2; ++half)
    by_half[half] = regress(halves[half], halves[1 - half], variance, features, settings.regression,
                            part_of(progress, half == 0 ? 0.1 : 0.55, half == 0 ? 0.55 : 1));
  const Halves wide{by_half[0][0], by_half[1][0]}, narrow{by_half[0][1], by_half[1][1]};
  const Plane share = blend(errors_of(wide, narrow, halves, variance, settings.blend_radius), settings.blend_radius);
  Colour result = black(image.width, image.height);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < result[c].values().size(); ++i) {
      const float u = 0.5f * (wide[0][c].values()[i] + wide[1][c].values()[i]);
      const float v = 0.5f * (narrow[0][c].values()[i] + narrow[1][c].values()[i]);
      result[c].values()[i] = (u + share.values()[i] * (v - u)) * albedo[c].values()[i] * unit;
    }
  add_filtered_emission(result, image);
  return result;
}

}  // namespace lambert::denoise
