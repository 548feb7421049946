#include "lambert/bsdf/albedo_tables.h"

#include "lambert/bsdf/fresnel.h"
#include "lambert/bsdf/microfacet.h"
#include "lambert/bsdf/sheen.h"
#include "lambert/sampling/sobol.h"
#include "lambert/sampling/warp.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lambert {
namespace {

constexpr int side = 24, samples = 256;

Vec2 sobol_point(std::uint32_t i) {
  const auto to_float = [](std::uint32_t bits) { return (static_cast<float>(bits >> 8) + 0.5f) * 0x1p-24f; };
  return {to_float(reverse_bits(i)), to_float(reverse_bits(pascal_bits(i)))};
}

/// Nodes lie at cos² spacing: albedos change fastest at grazing directions.
float node(int i) { return std::max(sqr(static_cast<float>(i) / (side - 1)), 1e-3f); }

Vec3 direction(float cos_theta) { return {std::sqrt(1 - cos_theta * cos_theta), 0, cos_theta}; }

GgxAlbedo integrate_ggx(float cos_theta, float alpha) {
  const Vec3 wo = direction(cos_theta);
  const Ggx ggx(alpha, alpha);
  GgxAlbedo sum{0, 0};
  for (std::uint32_t i = 0; i < samples; ++i) {
    const Vec3 h = ggx.sample_visible(wo, sobol_point(i)), wi = reflect(wo, h);
    if (wi.z <= 0) continue;
    const float weight = ggx.g2(wo, wi) / ggx.g1(wo), schlick = schlick_weight(dot(wo, h));
    sum.scale += weight * (1 - schlick), sum.bias += weight * schlick;
  }
  return {sum.scale / samples, sum.bias / samples};
}

float integrate_sheen(float cos_theta, float roughness) {
  const Vec3 wo = direction(cos_theta);
  float sum = 0;
  for (std::uint32_t i = 0; i < 4 * samples; ++i) {
    const Vec3 wi = square_to_uniform_hemisphere(sobol_point(i));
    sum += sheen_value(wo, wi, roughness) * wi.z;
  }
  return std::min(1.0f, sum * 2 * pi / (4 * samples));
}

template <class T>
using Table = std::array<std::array<T, side>, side>;  // [roughness][cos]

/// Value and neighbours for bilinear interpolation in (root of cos, root of roughness).
template <class T, class Mix>
T interpolate(const Table<T>& table, float cos_theta, float roughness, const Mix& mix) {
  const float x = std::sqrt(std::clamp(cos_theta, 0.0f, 1.0f)) * (side - 1),
              y = std::sqrt(std::clamp(roughness, 0.0f, 1.0f)) * (side - 1);
  const int i = std::min(static_cast<int>(x), side - 2), j = std::min(static_cast<int>(y), side - 2);
  const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
  const auto &lower = table[static_cast<std::size_t>(j)], &upper = table[static_cast<std::size_t>(j) + 1];
  const auto c = static_cast<std::size_t>(i);
  return mix(mix(lower[c], lower[c + 1], s), mix(upper[c], upper[c + 1], s), t);
}

template <class T, class Integrate>
Table<T> tabulate(const Integrate& integrate) {
  Table<T> table;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      table[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = integrate(node(i), node(j));
  return table;
}

GgxAlbedo mix_albedo(GgxAlbedo a, GgxAlbedo b, float t) {
  return {a.scale + t * (b.scale - a.scale), a.bias + t * (b.bias - a.bias)};
}
float mix_float(float a, float b, float t) { return a + t * (b - a); }

const Table<GgxAlbedo>& ggx_table() {
  static const Table<GgxAlbedo> table = tabulate<GgxAlbedo>(integrate_ggx);
  return table;
}

/// ∫ albedo(cos) 2 cos d(cos) for each roughness of the table.
const std::array<GgxAlbedo, side>& ggx_means() {
  static const std::array<GgxAlbedo, side> means = [] {
    std::array<GgxAlbedo, side> all;
    constexpr int steps = 64;
    for (int j = 0; j < side; ++j) {
      GgxAlbedo sum{0, 0};
      for (int k = 0; k < steps; ++k) {
        const float c = (static_cast<float>(k) + 0.5f) / steps;
        const GgxAlbedo a = interpolate(ggx_table(), c, node(j), mix_albedo);
        sum.scale += a.scale * 2 * c / steps, sum.bias += a.bias * 2 * c / steps;
      }
      all[static_cast<std::size_t>(j)] = sum;
    }
    return all;
  }();
  return means;
}

}  // namespace

GgxAlbedo ggx_albedo(float cos_theta, float alpha) { return interpolate(ggx_table(), cos_theta, alpha, mix_albedo); }

GgxAlbedo ggx_mean_albedo(float alpha) {
  const float y = std::sqrt(std::clamp(alpha, 0.0f, 1.0f)) * (side - 1);
  const int j = std::min(static_cast<int>(y), side - 2);
  const auto& means = ggx_means();
  return mix_albedo(means[static_cast<std::size_t>(j)], means[static_cast<std::size_t>(j) + 1],
                    y - static_cast<float>(j));
}

float sheen_albedo(float cos_theta, float roughness) {
  static const Table<float> table = tabulate<float>(integrate_sheen);
  return interpolate(table, cos_theta, roughness, mix_float);
}

}  // namespace lambert
