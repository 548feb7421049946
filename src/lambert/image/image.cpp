#include "lambert/image/image.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace lambert {

Image::Image(int width, int height, std::vector<std::string> channels)
    : width_(width), height_(height), channels_(std::move(channels)) {
  constexpr std::uint64_t most_floats = std::uint64_t{1} << 31;
  const std::string size =
      std::to_string(width) + "x" + std::to_string(height) + " with " + std::to_string(channels_.size()) + " channels";
  if (width <= 0 || height <= 0 || channels_.empty()) throw Error("an image cannot be " + size);
  const std::uint64_t pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  if (pixels > most_floats / channels_.size()) throw Error("an image of " + size + " is too large");
  pixels_.resize(static_cast<std::size_t>(pixels) * channels_.size());
}

void Image::place(Vec2i origin, const Window& display) {
  if (display.width <= 0 || display.height <= 0)
    throw Error("a display window cannot be " + std::to_string(display.width) + "x" + std::to_string(display.height));
  origin_ = origin;
  display_ = display;
}

std::optional<std::size_t> Image::channel(std::string_view name) const {
  const auto it = std::find(channels_.begin(), channels_.end(), name);
  if (it == channels_.end()) return std::nullopt;
  return static_cast<std::size_t>(it - channels_.begin());
}

Rgb Image::rgb(int x, int y) const {
  const float* p = &pixels_[index(x, y)];
  return has_colour() ? Rgb(p[0], p[1], p[2]) : Rgb(p[0]);
}

void Image::set_rgb(int x, int y, Rgb c) {
  float* p = &pixels_[index(x, y)];
  p[0] = c.r, p[1] = c.g, p[2] = c.b;
}

Image cut(Image image, const Window& window) {
  if (window == image.data_window()) return image;
  Image result(window.width, window.height, image.channels());
  result.place({window.x, window.y}, image.display_window());
  result.metadata = std::move(image.metadata);
  result.attributes = std::move(image.attributes);
  // In 64 bits: windows may lie anywhere in the plane.
  const Window data = image.data_window();
  const auto overlap = [](int a, int a_size, int b, int b_size) {
    const std::int64_t first = std::max(a, b);
    const std::int64_t last = std::min(std::int64_t{a} + a_size, std::int64_t{b} + b_size);
    return std::pair{first, std::max(first, last)};
  };
  const auto [x0, x1] = overlap(data.x, data.width, window.x, window.width);
  const auto [y0, y1] = overlap(data.y, data.height, window.y, window.height);
  const std::size_t channels = image.channel_count();
  const auto columns = [&](std::int64_t x) { return static_cast<std::size_t>(x) * channels; };
  for (std::int64_t y = y0; y < y1 && x0 < x1; ++y) {
    const auto from = image.row(static_cast<int>(y - data.y)).subspan(columns(x0 - data.x), columns(x1 - x0));
    std::ranges::copy(from, result.row(static_cast<int>(y - window.y)).subspan(columns(x0 - window.x)).begin());
  }
  return result;
}

Image displayed(Image image) {
  const Window shown = image.display_window();
  return cut(std::move(image), shown);
}

std::vector<std::string> rgb_channels() { return {"R", "G", "B"}; }
std::vector<std::string> rgba_channels() { return {"R", "G", "B", "A"}; }

}  // namespace lambert
