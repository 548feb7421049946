#pragma once
/// Linear RGB with Rec. 709 primaries: radiance, reflectance or any other coloured quantity.

#include <algorithm>
#include <cmath>

namespace lambert {

struct Rgb {
  float r = 0, g = 0, b = 0;

  constexpr Rgb() = default;
  constexpr explicit Rgb(float grey) : r(grey), g(grey), b(grey) {}
  constexpr Rgb(float red, float green, float blue) : r(red), g(green), b(blue) {}

  constexpr bool operator==(const Rgb&) const = default;
  constexpr float operator[](int i) const { return i == 0 ? r : i == 1 ? g : b; }

  constexpr Rgb& operator+=(Rgb o) { return *this = Rgb(r + o.r, g + o.g, b + o.b); }
  constexpr Rgb& operator*=(Rgb o) { return *this = Rgb(r * o.r, g * o.g, b * o.b); }
  constexpr Rgb& operator*=(float s) { return *this = Rgb(r * s, g * s, b * s); }
  friend constexpr Rgb operator+(Rgb a, Rgb c) { return {a.r + c.r, a.g + c.g, a.b + c.b}; }
  friend constexpr Rgb operator-(Rgb a, Rgb c) { return {a.r - c.r, a.g - c.g, a.b - c.b}; }
  friend constexpr Rgb operator*(Rgb a, Rgb c) { return {a.r * c.r, a.g * c.g, a.b * c.b}; }
  friend constexpr Rgb operator/(Rgb a, Rgb c) { return {a.r / c.r, a.g / c.g, a.b / c.b}; }
  friend constexpr Rgb operator*(Rgb a, float s) { return {a.r * s, a.g * s, a.b * s}; }
  friend constexpr Rgb operator*(float s, Rgb a) { return a * s; }
  friend constexpr Rgb operator/(Rgb a, float s) { return a * (1.0f / s); }
};

/// Relative luminance Y (Rec. 709 weights).
constexpr float luminance(Rgb c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }
constexpr float max_component(Rgb c) { return std::max(c.r, std::max(c.g, c.b)); }
constexpr float min_component(Rgb c) { return std::min(c.r, std::min(c.g, c.b)); }
constexpr float average(Rgb c) { return (c.r + c.g + c.b) * (1.0f / 3.0f); }
constexpr bool is_black(Rgb c) { return c == Rgb(); }
inline bool is_finite(Rgb c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }
constexpr Rgb lerp(Rgb a, Rgb b, float t) { return a * (1 - t) + b * t; }
constexpr Rgb max(Rgb a, Rgb b) { return {std::max(a.r, b.r), std::max(a.g, b.g), std::max(a.b, b.b)}; }
constexpr Rgb clamp(Rgb c, float lo, float hi) {
  return {std::clamp(c.r, lo, hi), std::clamp(c.g, lo, hi), std::clamp(c.b, lo, hi)};
}
inline Rgb exp(Rgb c) { return {std::exp(c.r), std::exp(c.g), std::exp(c.b)}; }
inline Rgb sqrt(Rgb c) { return {std::sqrt(c.r), std::sqrt(c.g), std::sqrt(c.b)}; }

}  // namespace lambert
