#pragma once
#include "lambert/image/formats/codecs.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lambert {

/// The rows of a PNG image that is not interlaced and has whole bytes per pixel, as libpng would give them without any
/// transformation; two to three times as fast, as all is inflated at once.
struct PngRows {
  std::vector<std::uint8_t> pixels;  ///< row_bytes * height
  std::size_t end = 0;               ///< of the file, behind the image data
};

/// `begin` is where the first IDAT chunk begins. Allocates what is in the file and (row_bytes + 1) * height, which the
/// caller has to have found reasonable. Nothing where there is damage, or more data than the rows need: libpng knows
/// what to say.
std::optional<PngRows> png_rows(Bytes file, std::size_t begin, std::size_t row_bytes, std::size_t height,
                                std::size_t pixel_bytes);

}  // namespace lambert
