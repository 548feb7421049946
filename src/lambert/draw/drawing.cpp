#include "lambert/draw/drawing.h"

#include <algorithm>
#include <cmath>

namespace lambert::draw {
namespace {

Colour from_hsl(double hue, double saturation, double lightness) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue / 30, 12.0);
    const double a = saturation * std::min(lightness, 1 - lightness);
    const double value = lightness - a * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
    return static_cast<std::uint8_t>(std::lround(255 * value));
  };
  return {channel(0), channel(8), channel(4)};
}

/// Steps of the golden angle never come close to an earlier hue.
double hue(std::size_t index) { return std::fmod(212 + 137.50776405 * static_cast<double>(index % 360), 360.0); }

}  // namespace

std::string hex(const Colour& colour) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t c : {colour.red, colour.green, colour.blue}) {
    text += digits[c / 16];
    text += digits[c % 16];
  }
  return text;
}

Colour pastel(std::size_t index) { return from_hsl(hue(index), 0.72, 0.84); }
Colour strong(std::size_t index) { return from_hsl(hue(index), 0.75, 0.40); }

}  // namespace lambert::draw
