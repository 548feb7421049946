#pragma once
#include "lambert/draw/drawing.h"

#include <filesystem>

namespace lambert::draw {

/// As SVG for `.svg`, else as pixels in the image format of the extension. Throws Error naming the path.
void write_drawing(const std::filesystem::path& path, const Drawing& drawing);

}  // namespace lambert::draw
