#pragma once
#include "lambert/base/vec.h"

#include <algorithm>
#include <cmath>

namespace lambert {

/// A rectangle seen from the origin, in its own frame, with lengths in units of the distance to its plane; sampled
/// uniformly by solid angle (Ureña, Fajardo and King, "An Area-Preserving Parametrization for Spherical Rectangles",
/// 2013). The units take all but one inverse trigonometric function out of the paper's formulas:
///
/// By Girard Ω = g₀ + g₁ + g₂ + g₃ - 2π. The angle at the corner (x, y) has cos g = ±xy / w and sin g = r / w with
/// r² = 1 + x² + y² and w² = (1 + x²)(1 + y²), so Ω is the argument of the product of the four numbers ±xy + i r. It is
/// good to 1e-5 of itself from 0.002 sr on, as long as no corner is further away than about 1e3.
class ProjectedRectangle {
 public:
  ProjectedRectangle(Vec2 corner, Vec2 size)
      : x0_(corner.x), y0_(corner.y), x1_(corner.x + size.x), y1_(corner.y + size.y) {
    const Complex first = Complex{x1_ * y0_, radius(x1_, y0_)} * Complex{-x1_ * y1_, radius(x1_, y1_)};
    const Complex last = Complex{x0_ * y1_, radius(x0_, y1_)} * Complex{-x0_ * y0_, radius(x0_, y0_)};
    const Complex all = first * last;
    const float argument = std::atan2(all.im, all.re);
    solid_angle_ = argument < 0 ? argument + 2 * pi : argument;
    k_ = {last.re, -last.im};
  }

  float solid_angle() const { return solid_angle_; }

  /// A point of the rectangle as its offset from the corner; the density is 1 / solid_angle() per steradian.
  Vec2 sample(Vec2 u) const {
    // With k = 2π - g₂ - g₃ and a = u Ω + k the part u of the area lies below x = ± sin a / √(t² - sin² a / (1 + y₀²)),
    // t = -(cos a y₀ / √(1 + y₀²) + y₁ / √(1 + y₁²)). Here t and the root are multiplied by √(1 + y₀²) √(1 + y₁²).
    const float s0 = std::sqrt(1 + y0_ * y0_), s1 = std::sqrt(1 + y1_ * y1_);
    const float angle = u.x * solid_angle_, inverse_length = 1 / ((1 + x0_ * x0_) * s0 * s1);
    const Complex a =
        Complex{std::cos(angle), std::sin(angle)} * Complex{k_.re * inverse_length, k_.im * inverse_length};
    const float t = -(a.re * y0_ * s1 + y1_ * s0);
    const float squared = std::max(t * t - sqr(a.im * s1), 1e-30f);
    const float x = std::clamp(std::copysign(a.im, a.im * t) * s0 * s1 / std::sqrt(squared), x0_, x1_);

    // Along the arc over x, h = y / √(1 + x² + y²) is uniform: h = n / d from y₀ to y₁, and y² = (1 + x²) h² / (1 -
    // h²).
    const float w = 1 + x * x;
    const float r0 = std::sqrt(w + y0_ * y0_), r1 = std::sqrt(w + y1_ * y1_);
    const float n = (1 - u.y) * y0_ * r1 + u.y * y1_ * r0, d2 = sqr(r0 * r1);
    const float y = std::clamp(n * std::sqrt(w / std::max(d2 - n * n, 1e-7f * d2)), y0_, y1_);
    return {x - x0_, y - y0_};
  }

 private:
  struct Complex {
    float re = 1, im = 0;
    friend Complex operator*(Complex a, Complex b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
  };
  static float radius(float x, float y) { return std::sqrt(1 + x * x + y * y); }

  float x0_, y0_, x1_, y1_;
  float solid_angle_;
  Complex k_;
};

}  // namespace lambert
