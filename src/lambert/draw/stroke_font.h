#pragma once
/// Letters as strokes, for pictures in pixels.

#include "lambert/draw/drawing.h"

#include <string_view>
#include <vector>

namespace lambert::draw {

/// The strokes of a line of ASCII text whose base line begins at `at`, y down; capitals are 0.7 `size` high. Characters
/// without a shape of their own are drawn as an empty box.
std::vector<Ring> text_strokes(std::string_view text, Vec2d at, double size);
double text_width(std::string_view text, double size);

}  // namespace lambert::draw
