#pragma once
#include "lambert/image/image.h"

namespace lambert {

/// Grey-scale erosion and dilation by a rectangle of (2 radius.x + 1) × (2 radius.y + 1) pixels: the least and the
/// greatest value there, per channel; what is outside the image does not count. Time does not depend on the radius.
/// See sliding_window.h for NaN and errors.
Image eroded(const Image& image, Vec2i radius);
Image dilated(const Image& image, Vec2i radius);
/// Dilation of the erosion (removes specks) and erosion of the dilation (closes holes).
Image opened(const Image& image, Vec2i radius);
Image closed(const Image& image, Vec2i radius);

}  // namespace lambert
