#include "lambert/image/probe/mirror_ball.h"

#include <algorithm>
#include <cmath>

namespace lambert::probe {
namespace {

/// sin γ at image radius r of [0, 1]: tan β = r tan β_max, tan β_max = 1 / √(D² - 1).
float sin_gamma(float r, float distance) {
  const float tan_beta = r / std::sqrt(sqr(distance) - 1);
  return std::min(1.0f, distance * tan_beta / std::sqrt(1 + sqr(tan_beta)));
}

}  // namespace

float MirrorBall::angle(float r) const {
  if (std::isinf(distance)) return 2 * std::asin(r);
  const float s = sin_gamma(r, distance);
  return 2 * std::asin(s) - std::asin(s / distance);
}

float MirrorBall::radius(float theta) const {
  if (std::isinf(distance)) return std::sin(0.5f * theta);
  const float last = pi - std::asin(1 / distance);
  if (theta > last) return 2;
  // θ(γ) = 2γ - asin(sin γ / D) rises with a slope between 1 and 2 and is nearly straight.
  float gamma = 0.5f * pi * theta / last;
  for (int i = 0; i < 6; ++i) {
    const float s = std::sin(gamma), slope = 2 - std::cos(gamma) / std::sqrt(sqr(distance) - sqr(s));
    gamma = std::clamp(gamma - (2 * gamma - std::asin(s / distance) - theta) / slope, 0.0f, 0.5f * pi);
  }
  const float s = std::sin(gamma);
  return std::min(1.0f, s * std::sqrt((sqr(distance) - 1) / (sqr(distance) - sqr(s))));
}

Vec3 MirrorBall::from_near(Vec2 p) const {
  const float r = length(p), theta = angle(r);
  return Vec3(r > 0 ? p * (std::sin(theta) / r) : Vec2(0), std::cos(theta));
}

std::optional<MapPoint> MirrorBall::point(Vec3 d) const {
  const float across = std::hypot(d.x, d.y), r = radius(std::atan2(across, d.z));
  if (r > 1) return std::nullopt;
  return MapPoint{0, disk_uv(r * (across > 0 ? Vec2(d) / across : Vec2(1, 0)))};
}

float MirrorBall::density(MapPoint at) const {
  const Vec2 p = disk_point(at.uv);
  const float r2 = dot(p, p);
  if (r2 > 1) return 0;
  if (std::isinf(distance)) return 16;
  const float r = std::sqrt(r2), d2 = sqr(distance);
  if (r < 1e-4f) return 4 * sqr(2 * distance - 1) / (d2 - 1);
  // dω / dA = sin θ (dθ/dγ) / (r dr/dγ); at the rim cos γ = 0 and it has an integrable pole.
  const float s = sin_gamma(r, distance), cos_gamma = std::max(std::sqrt(1 - s * s), 1e-3f);
  const float theta = angle(r);
  const float theta_by_gamma = 2 - cos_gamma / std::sqrt(d2 - s * s);
  const float r_by_gamma = cos_gamma * std::sqrt(d2 - 1) * d2 / std::pow(d2 - s * s, 1.5f);
  return 4 * std::sin(theta) * theta_by_gamma / (r * r_by_gamma);
}

}  // namespace lambert::probe
