#include "lambert/draw/write_drawing.h"

#include "lambert/base/file.h"
#include "lambert/base/standard_streams.h"
#include "lambert/draw/pixels.h"
#include "lambert/draw/svg.h"
#include "lambert/image/io.h"

namespace lambert::draw {

void write_drawing(const std::filesystem::path& path, const Drawing& drawing) {
  if (format_extension(path) == ".svg") {
    write_atomically(path, svg_text(drawing));
  } else {
    write_image(path, to_image(rasterised(drawing)));
  }
}

}  // namespace lambert::draw
