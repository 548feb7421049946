#include "lambert/material/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert {
namespace {

constexpr int first_nm = 360, last_nm = 830;

/// exp(-t²/2) with another width on each side of the mean.
float lobe(float x, float mean, float width_below, float width_above) {
  const float t = (x - mean) / (x < mean ? width_below : width_above);
  return std::exp(-0.5f * t * t);
}

float value_at(const SpectrumSamples& s, float nm) {
  const auto above =
      std::upper_bound(s.begin(), s.end(), nm, [](float x, const auto& sample) { return x < sample.first; });
  if (above == s.begin()) return s.front().second;
  if (above == s.end()) return s.back().second;
  const auto below = above - 1;
  const float t = (nm - below->first) / (above->first - below->first);
  return (1 - t) * below->second + t * above->second;
}

/// ∫ value(λ) x̄ȳz̄ dλ / ∫ ȳ dλ, in steps of 1 nm.
template <class Value>
Xyz integrate(const Value& value) {
  std::array<double, 3> sum{};
  double norm = 0;
  for (int nm = first_nm; nm <= last_nm; ++nm) {
    const Xyz c = cie_1931(static_cast<float>(nm));
    const double v = static_cast<double>(value(static_cast<float>(nm)));
    sum[0] += v * static_cast<double>(c.x), sum[1] += v * static_cast<double>(c.y),
        sum[2] += v * static_cast<double>(c.z);
    norm += static_cast<double>(c.y);
  }
  return {static_cast<float>(sum[0] / norm), static_cast<float>(sum[1] / norm), static_cast<float>(sum[2] / norm)};
}

}  // namespace

Xyz cie_1931(float nm) {
  return {1.056f * lobe(nm, 599.8f, 37.9f, 31.0f) + 0.362f * lobe(nm, 442.0f, 16.0f, 26.7f) -
              0.065f * lobe(nm, 501.1f, 20.4f, 26.2f),
          0.821f * lobe(nm, 568.8f, 46.9f, 40.5f) + 0.286f * lobe(nm, 530.9f, 16.3f, 31.1f),
          1.217f * lobe(nm, 437.0f, 11.8f, 36.0f) + 0.681f * lobe(nm, 459.0f, 26.0f, 13.8f)};
}

/// IEC 61966-2-1: Rec. 709 primaries, white D65.
Rgb xyz_to_rgb(Xyz c) {
  return {3.2404542f * c.x - 1.5371385f * c.y - 0.4985314f * c.z,
          -0.9692660f * c.x + 1.8760108f * c.y + 0.0415560f * c.z,
          0.0556434f * c.x - 0.2040259f * c.y + 1.0572252f * c.z};
}

Rgb spectrum_to_emission_rgb(const SpectrumSamples& s) {
  if (s.empty()) return Rgb();
  return xyz_to_rgb(integrate([&](float nm) { return value_at(s, nm); }));
}

Rgb spectrum_to_reflectance_rgb(const SpectrumSamples& s) {
  static const Rgb white = xyz_to_rgb(integrate([](float) { return 1.0f; }));
  return spectrum_to_emission_rgb(s) / white;
}

/// B(λ) ∝ λ⁻⁵ / (exp(c₂ / (λ T)) - 1), with its maximum at λ T = b (Wien).
SpectrumSamples blackbody(float kelvin) {
  constexpr double c2_nm_kelvin = 1.438776877e7, wien_nm_kelvin = 2.897771955e6;
  const double t = static_cast<double>(kelvin);
  SpectrumSamples samples;
  if (!(t > 0)) return {{static_cast<float>(first_nm), 0.0f}};
  const auto planck = [&](double nm) { return std::pow(nm, -5.0) / std::expm1(c2_nm_kelvin / (nm * t)); };
  const double peak = planck(wien_nm_kelvin / t);
  for (int nm = first_nm; nm <= last_nm; nm += 5) {
    samples.emplace_back(static_cast<float>(nm), static_cast<float>(planck(nm) / peak));
  }
  return samples;
}

}  // namespace lambert
