#pragma once
/// Environments for tests, given as functions of direction.

#include "lambert/base/hash.h"
#include "lambert/base/parallel.h"
#include "lambert/image/probe/texels.h"

#include <cstdint>

namespace lambert::probe {

/// The mean of f over each texel, by n x n points of its solid angle; f is called from several threads.
template <class F>
Probe map_of(const AnyProjection& projection, int rows, const F& f, int n = 1, TexelRule rule = TexelRule::cells) {
  Probe probe{projection, rule, {}};
  const Vec2i size = chart_size(projection, rows);
  for (int chart = 0; chart < chart_count(projection); ++chart) {
    probe.charts.emplace_back(size.x, size.y, rgb_channels());
    Image& image = probe.charts.back();
    parallel_for(static_cast<std::size_t>(size.y), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < size.x; ++x) {
        Rgb sum;
        float weight = 0;
        for (int k = 0; k < n * n; ++k) {
          const Vec2 inside = (Vec2(k % n, k / n) + 0.5f) / static_cast<float>(n);
          const MapPoint at{chart, uv_of(probe, Vec2(x, y) + inside)};
          const auto d = direction(projection, at);
          if (!d) continue;
          const float w = density(projection, at);
          sum += w * f(*d), weight += w;
        }
        if (weight > 0) image.set_rgb(x, y, sum / weight);
      }
    });
  }
  return probe;
}

inline Vec3 random_direction(std::uint64_t i) {
  const float z = 2 * hash_to_float(hash_values(i, std::uint64_t{1})) - 1;
  const float phi = 2 * pi * hash_to_float(hash_values(i, std::uint64_t{2}));
  const float ring = std::sqrt(std::max(0.0f, 1 - z * z));
  return {ring * std::cos(phi), ring * std::sin(phi), z};
}

/// Smooth, positive, without symmetry, of a few degrees of detail.
inline Rgb pattern(Vec3 d) {
  const float a = std::sin(5 * d.x + 2 * d.y), b = std::cos(7 * d.y - 3 * d.z + 1),
              c = std::sin(4 * d.z + 6 * d.x * d.y);
  return Rgb(2 + a + 0.5f * c, 2 + b, 1.5f + c + 0.3f * a * b);
}

/// ∫ L dω over all texels.
inline Rgb total_light(const Probe& probe) {
  const TexelMeasure m = texel_measure(probe);
  double sum[3] = {};
  for (const Image& chart : probe.charts)
    for (int y = 0; y < chart.height(); ++y)
      for (int x = 0; x < chart.width(); ++x) {
        const auto i = static_cast<std::size_t>(y * chart.width() + x);
        for (int k = 0; k < 3; ++k) sum[k] += static_cast<double>(chart.rgb(x, y)[k] * m.solid_angle[i]);
      }
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

}  // namespace lambert::probe
