#include "lambert/image/probe/spherical_harmonics.h"

#include "lambert/base/error.h"
#include "lambert/base/parallel.h"
#include "lambert/image/probe/texels.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lambert::probe {
namespace {

constexpr std::size_t most_coefficients = sh_count(highest_sh_order);

int order_of(std::size_t coefficients) {
  int order = 0;
  while (sh_count(order + 1) <= coefficients) ++order;
  return order;
}

/// K_lm = √((2l+1)/4π (l-m)!/(l+m)!), √2 of it for m > 0.
const std::array<double, most_coefficients>& factors() {
  static const auto table = [] {
    std::array<double, most_coefficients> k{};
    for (int l = 0; l <= highest_sh_order; ++l)
      for (int m = 0; m <= l; ++m) {
        double v = (2 * l + 1) / (4 * std::numbers::pi) * (m > 0 ? 2 : 1);
        for (int i = l - m + 1; i <= l + m; ++i) v /= i;
        k[static_cast<std::size_t>(l * l + l + m)] = std::sqrt(v);
      }
    return k;
  }();
  return table;
}

}  // namespace

/// P_mm / sin^m θ = (2m-1)!!, (l-m) P_lm = (2l-1) z P_l-1,m - (l+m-1) P_l-2,m; sin^m θ cos mφ and sin^m θ sin mφ are
/// the parts of (x + iy)^m.
void sh_basis(int order, Vec3 d, std::span<double> values) {
  const auto& k = factors();
  const double x = static_cast<double>(d.x), y = static_cast<double>(d.y), z = static_cast<double>(d.z);
  double cosine = 1, sine = 0, p_mm = 1;
  for (int m = 0; m <= order; ++m) {
    double before = 0, p = p_mm;
    for (int l = m; l <= order; ++l) {
      if (l > m) {
        const double next = ((2 * l - 1) * z * p - (l + m - 1) * before) / (l - m);
        before = p, p = next;
      }
      const auto middle = static_cast<std::size_t>(l * l + l), um = static_cast<std::size_t>(m);
      const double scaled = k[middle + um] * p;
      values[middle + um] = scaled * cosine;
      if (m > 0) values[middle - um] = scaled * sine;
    }
    p_mm *= 2 * m + 1;
    const double c = cosine * x - sine * y;
    sine = cosine * y + sine * x, cosine = c;
  }
}

std::vector<ShColour> sh_project(const Probe& probe, int order) {
  if (order < 0 || order > highest_sh_order)
    throw Error("spherical harmonics: the order must be from 0 to " + std::to_string(highest_sh_order));
  const std::size_t count = sh_count(order);
  const TexelMeasure measure = texel_measure(probe);
  const auto width = static_cast<std::size_t>(probe.width()), height = static_cast<std::size_t>(probe.height());
  // Sums of rows, added up in their order: the same for any number of threads.
  std::vector<std::vector<ShColour>> rows(probe.charts.size() * height);
  parallel_for(rows.size(), [&](std::size_t i) {
    const std::size_t chart = i / height, y = i % height;
    const Image& image = probe.charts[chart];
    std::vector<ShColour>& sum = rows[i];
    sum.resize(count);
    std::array<double, most_coefficients> basis, mean;
    for (std::size_t x = 0; x < width; ++x) {
      constexpr float gauss = 0.288675135f;  // 1 / (2 √3)
      std::fill_n(mean.begin(), count, 0.0);
      double weight = 0;
      for (int k = 0; k < 4; ++k) {
        const Vec2 pixel = Vec2(x, y) + 0.5f + Vec2((k & 1) ? gauss : -gauss, (k & 2) ? gauss : -gauss);
        const MapPoint at{static_cast<int>(chart), uv_of(probe, pixel)};
        const auto d = direction(probe.projection, at);
        if (!d) continue;
        const auto w = static_cast<double>(density(probe.projection, at));
        sh_basis(order, *d, basis);
        for (std::size_t c = 0; c < count; ++c) mean[c] += w * basis[c];
        weight += w;
      }
      if (!(weight > 0)) continue;
      const double scale = static_cast<double>(measure.solid_angle[y * width + x]) / weight;
      const Rgb c = image.rgb(static_cast<int>(x), static_cast<int>(y));
      const double r = scale * static_cast<double>(c.r), g = scale * static_cast<double>(c.g),
                   b = scale * static_cast<double>(c.b);
      for (std::size_t j = 0; j < count; ++j) sum[j].r += r * mean[j], sum[j].g += g * mean[j], sum[j].b += b * mean[j];
    }
  });
  std::vector<ShColour> total(count);
  for (const auto& row : rows)
    for (std::size_t j = 0; j < count; ++j) total[j].r += row[j].r, total[j].g += row[j].g, total[j].b += row[j].b;
  return total;
}

Rgb sh_radiance(std::span<const ShColour> coefficients, Vec3 d) {
  std::array<double, most_coefficients> basis;
  sh_basis(order_of(coefficients.size()), d, basis);
  ShColour sum;
  for (std::size_t j = 0; j < coefficients.size(); ++j)
    sum.r += basis[j] * coefficients[j].r, sum.g += basis[j] * coefficients[j].g, sum.b += basis[j] * coefficients[j].b;
  return {static_cast<float>(sum.r), static_cast<float>(sum.g), static_cast<float>(sum.b)};
}

/// A_l = 2π (-1)^(l/2-1) / ((l+2)(l-1)) · l! / (2^l (l/2)!²) for even l.
double cosine_lobe(int l) {
  if (l == 1) return 2 * std::numbers::pi / 3;
  if (l % 2 != 0) return 0;
  if (l == 0) return std::numbers::pi;
  double ratio = 1;
  for (int i = 1; i <= l / 2; ++i) ratio *= (l / 2.0 + i) / (4.0 * i);
  return 2 * std::numbers::pi * (l / 2 % 2 == 0 ? -1 : 1) / ((l + 2.0) * (l - 1.0)) * ratio;
}

std::vector<ShColour> sh_irradiance(std::span<const ShColour> radiance) {
  std::vector<ShColour> result;
  for (int l = 0; sh_count(l) <= radiance.size(); ++l)
    for (std::size_t j = sh_count(l - 1); j < sh_count(l); ++j) {
      const double a = cosine_lobe(l);
      result.push_back({a * radiance[j].r, a * radiance[j].g, a * radiance[j].b});
    }
  return result;
}

Probe sh_map(std::span<const ShColour> coefficients, const AnyProjection& projection, TexelRule texels, int rows) {
  const Vec2i size = chart_size(projection, rows);
  Probe result{projection, texels, {}};
  for (int i = 0; i < chart_count(projection); ++i) result.charts.emplace_back(size.x, size.y, rgb_channels());
  for (int i = 0; i < chart_count(projection); ++i) {
    Image& chart = result.charts[static_cast<std::size_t>(i)];
    parallel_for(static_cast<std::size_t>(size.y), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < size.x; ++x)
        if (const auto d = direction(projection, {i, uv_of(result, Vec2(x, y) + 0.5f)}))
          chart.set_rgb(x, y, sh_radiance(coefficients, *d));
    });
  }
  return result;
}

}  // namespace lambert::probe
