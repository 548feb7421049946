#include "lambert/draw/write_drawing.h"

#include "lambert/base/file.h"
#include "lambert/draw/pixels.h"
#include "lambert/draw/svg.h"
#include "lambert/image/io.h"

namespace lambert::draw {

void write_drawing(const std::filesystem::path& path, const Drawing& drawing) {
  if (path.extension() == ".svg") {
    write_atomically(path, svg_text(drawing));
  } else {
    write_image(path, to_image(rasterised(drawing)));
  }
}

}  // namespace lambert::draw
