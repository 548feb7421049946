#pragma once
/// How a place in a texture becomes a value (rows AA-22, AA-24), once for all that holds texels. `fetch(x, y)` gives a
/// texel inside an image as a Vec4. (u, v) = (0, 0) is the top left corner of the top left texel; texel centres lie at
/// (i + 1/2) / size. Coordinates that are not finite count as 0.

#include "lambert/base/vec.h"
#include "lambert/image/filter/edge_mode.h"

#include <algorithm>
#include <cmath>

namespace lambert {

struct EdgeModes {
  EdgeMode u = EdgeMode::repeat, v = EdgeMode::repeat;
};

/// Far outside any image but small enough to convert to int.
inline float tame_coordinate(float x) { return std::isfinite(x) ? std::clamp(x, -1e6f, 1e6f) : 0; }

template <class Fetch>
Vec4 nearest_lookup(Vec2i size, Vec2 uv, EdgeModes edges, const Fetch& fetch) {
  const auto index = [](float t, int n, EdgeMode mode) {
    return edge_index(static_cast<int>(std::floor(tame_coordinate(t * static_cast<float>(n)))), n, mode);
  };
  const int x = index(uv.x, size.x, edges.u), y = index(uv.y, size.y, edges.v);
  return x < 0 || y < 0 ? Vec4(0) : fetch(x, y);
}

/// The four nearest texels, blended along both axes.
template <class Fetch>
Vec4 bilinear_lookup(Vec2i size, Vec2 uv, EdgeModes edges, const Fetch& fetch) {
  const float x = tame_coordinate(uv.x * static_cast<float>(size.x) - 0.5f);
  const float y = tame_coordinate(uv.y * static_cast<float>(size.y) - 0.5f);
  const float left = std::floor(x), top = std::floor(y);
  const float s = x - left, t = y - top;
  const int i = static_cast<int>(left), j = static_cast<int>(top);
  const int x0 = edge_index(i, size.x, edges.u), x1 = edge_index(i + 1, size.x, edges.u);
  const int y0 = edge_index(j, size.y, edges.v), y1 = edge_index(j + 1, size.y, edges.v);
  const auto at = [&](int column, int row) { return (column | row) < 0 ? Vec4(0) : fetch(column, row); };
  return (1 - t) * ((1 - s) * at(x0, y0) + s * at(x1, y0)) + t * ((1 - s) * at(x0, y1) + s * at(x1, y1));
}

/// Two levels of a pyramid, of which `at(level)` looks into one, blended by the fraction of `level`, in
/// [0, level_count - 1].
template <class At>
Vec4 blended_levels(float level, const At& at) {
  const int lower = static_cast<int>(level);
  const float t = level - static_cast<float>(lower);
  const Vec4 fine = at(lower);
  return t > 0 ? fine + t * (at(lower + 1) - fine) : fine;
}

/// The elliptically weighted average (Heckbert 1989): the texels within the ellipse that a round pixel of two Gaussian
/// deviations' radius covers, weighted by the Gaussian less its value at the ellipse. `center` and the `dx` and `dy` by
/// which a pixel's edges lie in the texture are in texels. Costs as many fetches as the ellipse has texels.
template <class Fetch>
Vec4 elliptical_lookup(Vec2i size, Vec2 center, Vec2 dx, Vec2 dy, EdgeModes edges, const Fetch& fetch) {
  // The ellipse is dᵀ Q⁻¹ d <= 1 with Q = J Jᵀ + I, which is the pixel's Gaussian and the texels' together.
  const float xx = dx.x * dx.x + dy.x * dy.x + 1, yy = dx.y * dx.y + dy.y * dy.y + 1, xy = dx.x * dx.y + dy.x * dy.y;
  const float determinant = xx * yy - xy * xy;
  const float a = yy / determinant, b = -2 * xy / determinant, c = xx / determinant;
  const Vec2 reach(std::sqrt(xx), std::sqrt(yy));
  const int first_x = static_cast<int>(std::ceil(center.x - reach.x)), last_x = static_cast<int>(center.x + reach.x);
  const int first_y = static_cast<int>(std::ceil(center.y - reach.y)), last_y = static_cast<int>(center.y + reach.y);
  const float at_edge = std::exp(-2.0f);
  Vec4 sum(0);
  float weights = 0;
  for (int y = first_y; y <= last_y; ++y) {
    const int row = edge_index(y, size.y, edges.v);
    const float v = static_cast<float>(y) - center.y;
    for (int x = first_x; x <= last_x; ++x) {
      const float u = static_cast<float>(x) - center.x;
      const float r = a * u * u + b * u * v + c * v * v;
      if (r >= 1) continue;
      const float w = std::exp(-2 * r) - at_edge;
      weights += w;
      if (const int column = edge_index(x, size.x, edges.u); (column | row) >= 0) sum += w * fetch(column, row);
    }
  }
  return weights > 0 ? sum / weights : Vec4(0);
}

}  // namespace lambert
