#pragma once
#include "lambert/image/image.h"
#include "lambert/image/plane.h"

namespace lambert::compare {

/// A colour for t in [0, 1], in linear light: from black through violet, red and orange to pale yellow, with a
/// lightness that grows evenly (straight pieces in Oklab, Ottosson 2020). Outside of the range and for NaN the nearest
/// end; an infinite value is white.
Rgb heat(float t);

/// heat(value / top) per pixel; where `top` is not positive, all is black.
Image false_colour(const Plane& plane, float top = 1);

}  // namespace lambert::compare
