#include "read_finite.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/io.h"
#include "lambert/image/probe/layout.h"
#include "lambert/image/probe/missing.h"

#include <fmt/format.h>

namespace lambert::cli {

Image read_finite(const std::string& path) {
  const std::string file = input_name(path);
  Image image = probe::whole_map(read_image(path));
  const std::size_t count = probe::fill_missing(image), pixels = image.pixels().size() / image.channel_count();
  if (count == pixels) throw Error(file + ": expected finite pixels, there is none");
  if (count > 0)
    log::warn(fmt::format("{}: {} not finite; filled from {} neighbours", file,
                          count == 1 ? "a pixel is" : fmt::format("{} pixels are", count),
                          count == 1 ? "its" : "their"));
  return image;
}

}  // namespace lambert::cli
