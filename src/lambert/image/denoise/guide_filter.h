#pragma once
#include "lambert/image/denoise/noisy_image.h"

#include <vector>

namespace lambert::denoise {

/// The guides freed of their noise by non-local means of themselves; depth in units of its mean. Guides without noise
/// stay exactly as they are.
std::vector<Guide> filter_guides(const std::vector<Guide>& guides, int window_radius);

/// What colour is divided by before filtering and multiplied with after it: the albedo, at least 0.01, or 1 where there
/// is none. `filtered` is what filter_guides() made of `guides`.
Colour modulation(const std::vector<Guide>& filtered, int width, int height);

/// The halves divided by `albedo` times `unit`.
std::array<Colour, 2> demodulated(const std::array<Colour, 2>& halves, const Colour& albedo, float unit);

/// Adds the emission to a filtered picture, itself filtered by non-local means.
void add_filtered_emission(Colour& to, const NoisyImage& image);

/// A power of two near the mean brightness of the picture divided by `albedo`; 1 for a black one.
float brightness_unit(const NoisyImage& image, const Colour& albedo);

}  // namespace lambert::denoise
