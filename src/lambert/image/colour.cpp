#include "lambert/image/colour.h"

#include <array>
#include <cmath>

namespace lambert {

float srgb_encode(float linear) {
  const float x = std::abs(linear);
  const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
  return std::copysign(encoded, linear);
}

float srgb_decode(float encoded) {
  const float x = std::abs(encoded);
  const float linear = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  return std::copysign(linear, encoded);
}

float srgb_decode8(std::uint8_t code) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgb_decode(static_cast<float>(i) / 255.0f);
    return t;
  }();
  return table[code];
}

}  // namespace lambert
