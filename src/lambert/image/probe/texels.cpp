#include "lambert/image/probe/texels.h"

#include "lambert/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace lambert::probe {
namespace {

/// The part of the chart that texel i of n stands for.
struct Span {
  double low, high;
};
Span span_of(TexelRule rule, int i, int n) {
  if (rule == TexelRule::cells) return {static_cast<double>(i) / n, static_cast<double>(i + 1) / n};
  if (n == 1) return {0, 1};
  return {std::max(0.0, (i - 0.5) / (n - 1)), std::min(1.0, (i + 0.5) / (n - 1))};
}

/// ∫∫ (1 + a² + b²)^-3/2 da db from (0, 0) to (a, b).
double cube_corner(double a, double b) { return std::atan2(a * b, std::sqrt(a * a + b * b + 1)); }

double cube_texel(Span u, Span v) {
  const double a0 = 2 * u.low - 1, a1 = 2 * u.high - 1, b0 = 2 * v.low - 1, b1 = 2 * v.high - 1;
  return cube_corner(a1, b1) - cube_corner(a0, b1) - cube_corner(a1, b0) + cube_corner(a0, b0);
}

double lat_long_texel(Span u, Span v) {
  constexpr double pi_d = std::numbers::pi;
  return 2 * pi_d * (u.high - u.low) * (std::cos(pi_d * v.low) - std::cos(pi_d * v.high));
}

double at(const AnyProjection& p, double u, double v) {
  return static_cast<double>(density(p, {0, {static_cast<float>(u), static_cast<float>(v)}}));
}

double by_rule(const AnyProjection& p, Span u, Span v) {
  const double area = (u.high - u.low) * (v.high - v.low);
  const bool cut =
      !(at(p, u.low, v.low) > 0 && at(p, u.high, v.low) > 0 && at(p, u.low, v.high) > 0 && at(p, u.high, v.high) > 0);
  const int n = cut ? 32 : 2;
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto place = [&](int k) { return cut ? (k + 0.5) / n : 0.5 + (k - 0.5) / std::sqrt(3.0); };
      sum += at(p, u.low + place(i) * (u.high - u.low), v.low + place(j) * (v.high - v.low));
    }
  return sum * area / (n * n);
}

double texel(const AnyProjection& p, Span u, Span v) {
  if (std::holds_alternative<LatLong>(p)) return lat_long_texel(u, v);
  if (std::holds_alternative<Cube>(p)) return cube_texel(u, v);
  if (std::holds_alternative<EqualArea>(p)) return 4 * std::numbers::pi * (u.high - u.low) * (v.high - v.low);
  return by_rule(p, u, v);
}

/// ∫∫ (sin θ sin φ, cos θ, -sin θ cos φ) sin θ dφ dθ; sums as middles and halves, which do not cancel.
Vec3 lat_long_moment(const Probe& probe, const LatLong& map, int x, int y) {
  const float half_phi = pi / static_cast<float>(probe.width());
  const float phi = half_phi * (2 * static_cast<float>(x) + 1) - pi;
  const double half_theta = 0.5 * std::numbers::pi / probe.height(), theta = half_theta * (2 * y + 1);
  // ∫ sin² θ = (Δ - cos 2θ sin Δ) / 2, ∫ sin θ cos θ = sin 2θ sin Δ / 2 about the middle θ with Δ = 2 half_theta
  const double delta = 2 * half_theta, sin_delta = std::sin(delta);
  const auto across = static_cast<float>(0.5 * (delta - std::cos(2 * theta) * sin_delta));
  const auto along = static_cast<float>(0.5 * std::sin(2 * theta) * sin_delta);
  const float ring = (map.centre_is_plus_z ? -2.0f : 2.0f) * std::sin(half_phi) * across;
  return {ring * std::sin(phi), 2 * half_phi * along, -ring * std::cos(phi)};
}

/// What a ball or a fisheye sees; 0 for maps without a rim.
double disk_solid_angle(const AnyProjection& p) {
  double half = 0;  // the angle from the axis
  if (const auto* ball = std::get_if<MirrorBall>(&p))
    half = std::numbers::pi - (std::isinf(ball->distance) ? 0 : std::asin(1 / static_cast<double>(ball->distance)));
  if (const auto* fisheye = std::get_if<Fisheye>(&p))
    half = 0.5 * static_cast<double>(fisheye->field_of_view.radians());
  return 2 * std::numbers::pi * (1 - std::cos(half));
}

}  // namespace

Vec2 uv_of(const Probe& probe, Vec2 pixel) {
  const Vec2 size(probe.width(), probe.height());
  if (probe.texels == TexelRule::cells) return pixel / size;
  return (pixel - 0.5f) / glm::max(size - 1.0f, Vec2(1));
}

Vec2 pixel_of(const Probe& probe, Vec2 uv) {
  const Vec2 size(probe.width(), probe.height());
  if (probe.texels == TexelRule::cells) return uv * size;
  return uv * (size - 1.0f) + 0.5f;
}

TexelMeasure texel_measure(const Probe& probe) {
  const int w = probe.width(), h = probe.height();
  TexelMeasure m;
  m.solid_angle.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  parallel_for(static_cast<std::size_t>(h), [&](std::size_t row) {
    const Span v = span_of(probe.texels, static_cast<int>(row), h);
    float* out = &m.solid_angle[row * static_cast<std::size_t>(w)];
    for (int x = 0; x < w; ++x) out[x] = static_cast<float>(texel(probe.projection, span_of(probe.texels, x, w), v));
  });
  if (const double seen = disk_solid_angle(probe.projection); seen > 0 && probe.texels == TexelRule::cells) {
    // The rim is cut by an even grid: what that misses is spread over all.
    double sum = 0;
    for (const float omega : m.solid_angle) sum += static_cast<double>(omega);
    for (float& omega : m.solid_angle) omega = static_cast<float>(static_cast<double>(omega) * seen / sum);
  }
  return m;
}

Vec3 texel_moment(const Probe& probe, int chart, int x, int y, float solid_angle) {
  if (const auto* map = std::get_if<LatLong>(&probe.projection); map && probe.texels == TexelRule::cells)
    return lat_long_moment(probe, *map, x, y);
  constexpr float gauss = 0.288675135f;  // 1 / (2 √3)
  const Vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  Vec3 sum(0);
  float weight = 0;
  for (int i = 0; i < 4; ++i) {
    const Vec2 offset((i & 1) ? gauss : -gauss, (i & 2) ? gauss : -gauss);
    const MapPoint p{chart, uv_of(probe, centre + offset)};
    const auto d = direction(probe.projection, p);
    if (!d) continue;
    const float w = density(probe.projection, p);
    sum += w * *d, weight += w;
  }
  return weight > 0 ? sum * (solid_angle / weight) : Vec3(0);
}

}  // namespace lambert::probe
