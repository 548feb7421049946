#include "lambert/sampling/spherical_rectangle.h"

#include <algorithm>
#include <cmath>

namespace lambert {

SphericalRectangle::SphericalRectangle(Vec3 from, Vec3 corner, Vec3 edge_u, Vec3 edge_v) {
  const float length_u = length(edge_u), length_v = length(edge_v);
  const Vec3 x = edge_u / length_u, y = edge_v / length_v, z = cross(x, y);
  const Vec3 d = corner - from;
  x0_ = dot(d, x), y0_ = dot(d, y);
  x1_ = x0_ + length_u, y1_ = y0_ + length_v;
  z0_ = -std::abs(dot(d, z));

  // The normals of the four planes through `from` and an edge have these z components; their angles add up to the
  // solid angle (Girard).
  const float n0 = -y0_ / std::sqrt(z0_ * z0_ + y0_ * y0_), n1 = x1_ / std::sqrt(z0_ * z0_ + x1_ * x1_);
  const float n2 = y1_ / std::sqrt(z0_ * z0_ + y1_ * y1_), n3 = -x0_ / std::sqrt(z0_ * z0_ + x0_ * x0_);
  const auto angle = [](float a, float b) { return std::acos(std::clamp(-a * b, -1.0f, 1.0f)); };
  const float g0 = angle(n0, n1), g1 = angle(n1, n2), g2 = angle(n2, n3), g3 = angle(n3, n0);
  b0_ = n0, b1_ = n2;
  k_ = 2 * pi - g2 - g3;
  solid_angle_ = std::max(0.0f, g0 + g1 - k_);
}

Vec2 SphericalRectangle::sample(Vec2 u) const {
  // cos of the great circle's tilt that cuts off the share u.x of the area.
  const float au = u.x * solid_angle_ + k_;
  const float fu = (std::cos(au) * b0_ - b1_) / std::sin(au);
  const float cu =
      std::clamp(std::copysign(1 / std::sqrt(fu * fu + b0_ * b0_), fu), -one_minus_epsilon, one_minus_epsilon);
  const float xu = std::clamp(-(cu * z0_) / std::sqrt(1 - cu * cu), x0_, x1_);

  // Along that circle heights are uniform.
  const float squared = xu * xu + z0_ * z0_;
  const float h0 = y0_ / std::sqrt(squared + y0_ * y0_), h1 = y1_ / std::sqrt(squared + y1_ * y1_);
  const float h = h0 + u.y * (h1 - h0), h2 = h * h;
  const float yv = h2 < 1 - 1e-6f ? h * std::sqrt(squared) / std::sqrt(1 - h2) : y1_;
  return {(xu - x0_) / (x1_ - x0_), std::clamp((yv - y0_) / (y1_ - y0_), 0.0f, 1.0f)};
}

Vec2 SphericalRectangle::to_square(Vec2 place) const {
  const float xu = x0_ + place.x * (x1_ - x0_), yv = y0_ + place.y * (y1_ - y0_);
  const float squared = xu * xu + z0_ * z0_;
  const float h0 = y0_ / std::sqrt(squared + y0_ * y0_), h1 = y1_ / std::sqrt(squared + y1_ * y1_);
  const float h = yv / std::sqrt(squared + yv * yv);

  // The area to the left of xu is that of the rectangle from x0 to xu.
  const float n1 = xu / std::sqrt(squared);
  const auto angle = [](float a, float b) { return std::acos(std::clamp(-a * b, -1.0f, 1.0f)); };
  const float left = angle(b0_, n1) + angle(n1, b1_) - k_;
  return {std::clamp(left / solid_angle_, 0.0f, 1.0f), std::clamp((h - h0) / (h1 - h0), 0.0f, 1.0f)};
}

}  // namespace lambert
