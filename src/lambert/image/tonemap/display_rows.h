#pragma once
/// What operators make of a row, and the image it goes into.

#include "lambert/image/image.h"
#include "lambert/image/tonemap/radiance_rows.h"

#include <string>
#include <vector>

namespace lambert::tone {

/// R, G, B, or Y where there is no colour; and A where the image has it.
std::vector<std::string> display_channels(const Image& image);
/// As large as `image` and placed as it is, with its metadata.
Image empty_display(const Image& image);

/// Clips colours to [0, 1] and puts them into row y of an image of display_channels(); with `alpha`, times alpha.
void store(const ColourRow& row, bool alpha, Image& out, int y);

/// Room for colour_from_luminance(), for as many rows as one likes.
struct LuminanceRow {
  explicit LuminanceRow(int width) : light(static_cast<std::size_t>(width)), shown(light), ratio(light) {}
  std::vector<float> light, shown, ratio;
};

/// c' = (c/L)^saturation L', L the luminance `light` and L' `shown`; a black pixel takes L' as its grey.
void colour_from_luminance(ColourRow& row, const float* light, const float* shown, float* ratio, float saturation);

}  // namespace lambert::tone
