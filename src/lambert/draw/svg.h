#pragma once
#include "lambert/draw/drawing.h"

#include <string>

namespace lambert::draw {

/// An SVG 1.1 document, coordinates to a hundredth of a pixel. Marks with a coordinate that is not finite are left out;
/// what of a text is not ASCII becomes '?'.
std::string svg_text(const Drawing& drawing);

}  // namespace lambert::draw
