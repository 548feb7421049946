#include "lambert/image/colour.h"

#include <array>
#include <bit>
#include <cmath>

namespace lambert {
namespace {

/// The least float whose code is `code`, 1 to 255.
float least_with_code(int code) {
  const double encoded = (code - 0.5) / 255;
  const double linear = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
  const auto nearest = static_cast<float>(linear);
  return static_cast<double>(nearest) < linear ? std::nextafter(nearest, 1.0f) : nearest;
}

/// The codes of floats from 2^-13, below the first step, to 1, by their exponent and first 7 bits. A code is at least
/// 1/112 of its light wide, a cell at most 1/128 of it and, above 1/2, where codes are finest, less: a cell has one
/// step at most.
struct CodeCells {
  static constexpr std::uint32_t drop = 16, first = 0x39000000u >> drop, last = 0x3f800000u >> drop;
  static constexpr std::size_t size = last - first + 1;
  std::array<float, size> step{};         // where the code goes up by one
  std::array<std::int32_t, size> code{};  // below the step

  CodeCells() {
    int code_here = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const auto cell = static_cast<std::uint32_t>(i) + first;
      const auto start = std::bit_cast<float>(cell << drop);
      while (code_here < 255 && least_with_code(code_here + 1) <= start) ++code_here;
      code[i] = code_here;
      step[i] = code_here < 255 ? least_with_code(code_here + 1) : 2.0f;
    }
  }
};

}  // namespace

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

void srgb_encode8(std::span<const float> linear, std::span<std::uint8_t> codes) {
  static const CodeCells cells;
  constexpr float least = 0x1p-13f;
  const float* const from = linear.data();
  const float* const step = cells.step.data();
  const std::int32_t* const code = cells.code.data();
  std::uint8_t* const to = codes.data();
  for (std::size_t i = 0; i < linear.size(); ++i) {
    const float above = from[i] > least ? from[i] : least;  // NaN is not above
    const float v = above < 1.0f ? above : 1.0f;
    const std::int32_t cell =
        (std::bit_cast<std::int32_t>(v) >> CodeCells::drop) - static_cast<std::int32_t>(CodeCells::first);
    to[i] = static_cast<std::uint8_t>(code[cell] + static_cast<std::int32_t>(v >= step[cell]));
  }
}

}  // namespace lambert
