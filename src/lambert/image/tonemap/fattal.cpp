#include "lambert/image/tonemap/fattal.h"

#include "lambert/image/tonemap/fast_math.h"
#include "lambert/image/tonemap/poisson.h"
#include "lambert/image/tonemap/pyramid.h"

#include <cmath>

namespace lambert::tone {
namespace {

/// Lengths of the gradient by central differences, per pixel of the finest level when pixels here are 2^k of those.
Plane gradient_lengths(const Plane& plane, int level) {
  Plane out(plane.width, plane.height);
  const float half = std::exp2(-static_cast<float>(level) - 1);
  for_rows(plane.height, [&](int y) {
    const auto up = plane.row(std::max(y - 1, 0)), down = plane.row(std::min(y + 1, plane.height - 1));
    const auto row = plane.row(y);
    const auto to = out.row(y);
    for (std::size_t x = 0; x < to.size(); ++x) {
      const float dx = row[std::min(x + 1, to.size() - 1)] - row[x > 0 ? x - 1 : 0], dy = down[x] - up[x];
      to[x] = half * std::sqrt(dx * dx + dy * dy);
    }
  });
  return out;
}

double mean(const Plane& plane) {
  double sum = 0;
  for (const float v : plane.values) sum += static_cast<double>(v);
  return sum / static_cast<double>(plane.values.size());
}

}  // namespace

Plane Fattal::attenuation(const Plane& logarithm) const {
  constexpr int coarsest = 32;
  std::vector<Plane> pyramid{logarithm};
  while (std::min(pyramid.back().width, pyramid.back().height) >= 2 * coarsest)
    pyramid.push_back(halved(pyramid.back()));
  Plane factors;
  for (std::size_t k = pyramid.size(); k-- > 0;) {
    Plane lengths = gradient_lengths(pyramid[k], static_cast<int>(k));
    const float unit = alpha * static_cast<float>(mean(lengths));
    // (a/|g|) (|g|/a)^beta
    for_rows(lengths.height, [&](int y) {
      for (float& v : lengths.row(y))
        v = unit > 0 ? fast_pow(std::max(v / unit, std::max(noise, 1e-6f)), beta - 1) : 1.0f;
    });
    if (!factors.values.empty()) {
      const Plane coarser = doubled(factors, lengths.width, lengths.height);
      for (std::size_t i = 0; i < lengths.values.size(); ++i) lengths.values[i] *= coarser.values[i];
    }
    factors = std::move(lengths);
  }
  return factors;
}

Plane with_scaled_gradients(const Plane& plane, const Plane& factors) {
  const int w = plane.width, h = plane.height;
  std::vector<double> divergence(plane.values.size(), 0.0);
  const auto flux = [&](int x, int y, int to_x, int to_y) {
    return 0.5 * static_cast<double>(factors.at(x, y) + factors.at(to_x, to_y)) *
           static_cast<double>(plane.at(to_x, to_y) - plane.at(x, y));
  };
  for_rows(h, [&](int y) {
    for (int x = 0; x < w; ++x) {
      double sum = 0;
      if (x > 0) sum += flux(x, y, x - 1, y);
      if (x + 1 < w) sum += flux(x, y, x + 1, y);
      if (y > 0) sum += flux(x, y, x, y - 1);
      if (y + 1 < h) sum += flux(x, y, x, y + 1);
      divergence[static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x)] = sum;
    }
  });
  const std::vector<double> solution = solve_poisson(w, h, std::move(divergence));
  Plane out(w, h);
  for (std::size_t i = 0; i < solution.size(); ++i) out.values[i] = static_cast<float>(solution[i]);
  return out;
}

Plane Fattal::map(const LuminanceMap& map) const {
  const float floor = map.percentile(0.1f);
  Plane logarithm = map.luminance;
  for_rows(logarithm.height, [&](int y) {
    for (float& v : logarithm.row(y)) v = fast_log2(std::max(v, floor));
  });
  LuminanceMap out;
  out.luminance = with_scaled_gradients(logarithm, attenuation(logarithm));
  for_rows(out.luminance.height, [&](int y) {
    for (float& v : out.luminance.row(y)) v = fast_exp2(contrast * v);
  });
  const float scale = 1 / out.percentile(100 - clip);
  for_rows(out.luminance.height, [&](int y) {
    const auto from = map.luminance.row(y);
    const auto to = out.luminance.row(y);
    // Below the floor in proportion, so that black is black.
    for (std::size_t x = 0; x < to.size(); ++x) to[x] *= from[x] < floor ? scale * (from[x] / floor) : scale;
  });
  return std::move(out.luminance);
}

}  // namespace lambert::tone
