#pragma once
#include "lambert/base/rgb.h"

#include <cstdint>
#include <span>

namespace lambert {

/// The sRGB transfer curve (IEC 61966-2-1), extended oddly below 0 and by its power law above 1.
float srgb_encode(float linear);
float srgb_decode(float encoded);
inline Rgb srgb_decode(Rgb c) { return {srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b)}; }
inline Rgb srgb_encode(Rgb c) { return {srgb_encode(c.r), srgb_encode(c.g), srgb_encode(c.b)}; }
/// By a table of the 256 codes.
float srgb_decode8(std::uint8_t code);
/// codes[i] is 255 times the curve at linear[i], clipped to [0, 1], rounded as the exact number is; NaN is 0. `codes`
/// holds as many as `linear`.
void srgb_encode8(std::span<const float> linear, std::span<std::uint8_t> codes);

}  // namespace lambert
