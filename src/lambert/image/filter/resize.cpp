#include "lambert/image/filter/resize.h"

#include "lambert/base/error.h"
#include "lambert/image/filter/separable.h"

#include <cmath>
#include <string>

namespace lambert {
namespace {

/// One direction of both windows.
struct Extent {
  int data_begin, data_size, display_begin, display_size;
};

struct Scaled {
  Extent to;
  LineMap map;
};

/// The display windows' corners lie on each other, and so do their far ends.
Scaled scaled(const Extent& from, int size) {
  const double scale = static_cast<double>(from.display_size) / size;
  constexpr double slack = 1e-9;  // a quotient that should be whole may lie beside it
  const double begin = (from.data_begin - from.display_begin) / scale;
  const double end = (static_cast<double>(from.data_begin) + from.data_size - from.display_begin) / scale;
  const int first = static_cast<int>(std::floor(begin + slack)), last = static_cast<int>(std::ceil(end - slack));
  const int display = static_cast<int>(std::lround(from.display_begin / scale));
  return {{display + first, std::max(1, last - first), display, size},
          {.in = from.data_size, .out = std::max(1, last - first), .scale = scale, .offset = first - begin}};
}

Taps taps_along(const Kernel& kernel, const LineMap& map, EdgeMode edge) {
  constexpr double most_radius = 64, most_taps = 1 << 26;
  if (kernel.radius() > most_radius) throw Error("a filter's radius for resizing can be at most 64 pixels");
  if (2 * kernel.radius() * std::max(1.0, map.scale) * map.out > most_taps)
    throw Error("resizing " + std::to_string(map.in) + " pixels to " + std::to_string(map.out) +
                " by a filter of radius " + std::to_string(kernel.radius()) + " reads too many");
  return resampling_taps(kernel, map, edge);
}

}  // namespace

Image resized(const Image& image, int width, int height, const ResizeSettings& settings) {
  const Window data = image.data_window(), display = image.display_window();
  constexpr int most = 1 << 28;
  if (width <= 0 || height <= 0 || width > most || height > most)
    throw Error("an image cannot be resized to " + std::to_string(width) + "x" + std::to_string(height));
  const Scaled x = scaled({data.x, data.width, display.x, display.width}, width);
  const Scaled y = scaled({data.y, data.height, display.y, display.height}, height);
  Image out =
      separably_filtered(image, taps_along(Kernel(settings.filter, Kernel::Axis::x), x.map, settings.edge),
                         taps_along(Kernel(settings.filter, Kernel::Axis::y), y.map, settings.edge), settings.progress);
  out.place({x.to.data_begin, y.to.data_begin}, {x.to.display_begin, y.to.display_begin, width, height});
  return out;
}

}  // namespace lambert
