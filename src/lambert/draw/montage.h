#pragma once
#include "lambert/image/image.h"

#include <span>
#include <string>

namespace lambert::draw {

/// An image with its name.
struct Panel {
  std::string name;
  Image image;  ///< colours or grey; alpha is shown over white
};

struct MontageSettings {
  int columns = 0;  ///< 0: as square as the panels allow
  int gap = 10;     ///< pixels around panels
  double caption_size = 13;
  std::string title = {};
};

/// All panels on one white sheet, row by row, each with its name below; cells are as large as the largest panel. Linear
/// light, channels R, G, B; panels keep their values. Names too long for their cell are written smaller. Throws Error
/// when there is no panel.
Image montage(std::span<const Panel> panels, const MontageSettings& settings = {});

/// Every pixel as a square of `factor` pixels.
Image magnified(const Image& image, int factor);

}  // namespace lambert::draw
