#pragma once
#include "lambert/image/hdr/stack.h"

#include <cstdint>
#include <vector>

namespace lambert::hdr {

/// A picture of 8-bit grey.
struct Grey {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  std::uint8_t at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  const std::uint8_t* row(int y) const {
    return pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
};

/// (54 R + 183 G + 19 B) / 256 of the codes as they are (Ward 2003), or the grey itself; of 16 bits the square roots.
Grey grey_of(const ExposureStack& stack, std::size_t frame);
/// Means of 2 by 2 pixels; an odd last column or row is left out.
Grey halved(const Grey& grey);
/// grey, halved, halved …: `levels` pictures, fewer when they become narrower than 8 pixels.
std::vector<Grey> pyramid(Grey grey, int levels);

}  // namespace lambert::hdr
