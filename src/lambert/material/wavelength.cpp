#include "lambert/material/spectrum.h"

#include "lambert/base/vec.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert {
namespace {

constexpr int first_nm = 380, last_nm = 720;
constexpr auto bin_count = static_cast<std::size_t>(last_nm - first_nm);

/// Bins of 1 nm. A bin is chosen with the mean of the three channels' shares of it, so that no weight exceeds 3 and the
/// three of them always add up to 3.
struct WavelengthTable {
  std::array<Rgb, bin_count> weight;
  std::array<float, bin_count> cumulative;  // up to and including the bin

  WavelengthTable() {
    std::array<Rgb, bin_count> colour;
    Rgb sum;
    for (std::size_t i = 0; i < bin_count; ++i) {
      // Colours outside the triangle of the primaries lose their negative part.
      colour[i] = max(xyz_to_rgb(cie_1931(static_cast<float>(first_nm) + static_cast<float>(i) + 0.5f)), Rgb());
      sum += colour[i];
    }
    float total = 0;
    for (std::size_t i = 0; i < bin_count; ++i) {
      const Rgb share = colour[i] / sum;
      const float probability = average(share);
      weight[i] = share / probability;
      cumulative[i] = total += probability;
    }
    cumulative.back() = 1;
  }
};

const WavelengthTable& table() {
  static const WavelengthTable t;
  return t;
}

}  // namespace

Rgb wavelength_rgb(float nm) {
  const float bin = std::clamp(nm - static_cast<float>(first_nm), 0.0f, static_cast<float>(bin_count - 1));
  return table().weight[static_cast<std::size_t>(bin)];
}

float sample_wavelength(float u) {
  const auto& cumulative = table().cumulative;
  const auto bin = std::upper_bound(cumulative.begin(), cumulative.end(), u);
  const float below = bin == cumulative.begin() ? 0 : *(bin - 1);
  const float t = std::min((u - below) / (*bin - below), 0.99f);  // so that rounding does not reach the next bin
  return static_cast<float>(first_nm) + static_cast<float>(bin - cumulative.begin()) + t;
}

/// V_d = (η_d - 1) / (η_F - η_C) and η_F - η_C = B (1/λ_F² - 1/λ_C²).
float cauchy_eta(float eta_d, float abbe_number, float nm) {
  constexpr float line_f = 486.1f, line_d = 587.6f, line_c = 656.3f;
  if (!(abbe_number > 0)) return eta_d;
  const float b = (eta_d - 1) / (abbe_number * (1 / sqr(line_f) - 1 / sqr(line_c)));
  return eta_d + b * (1 / sqr(nm) - 1 / sqr(line_d));
}

}  // namespace lambert
