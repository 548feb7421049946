#pragma once
#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

/// A rectangle of pixels on the picture's plane: columns [x, x + width), rows [y, y + height), y down.
struct Window {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Window&) const = default;
};

/// A value that travels with the image and is not plain text: OpenEXR's name of its type ("float", "v2f", "m44f",
/// "timecode", "rational", "chromaticities", "envmap", "stringvector" ...) and its numbers or words, parted by spaces.
struct Attribute {
  std::string type, value;
  bool operator==(const Attribute&) const = default;
};

/// Pixels as floats: rows from the top, channels interleaved, linear light, premultiplied alpha. Channels have EXR
/// names ("R", "G", "B", "A", "Z", "albedo.R", "normal.X"), so that layers are just channels. An image lies on the
/// picture's plane at its data window; the display window is what of the plane is shown. All of width(), at() and
/// row() count from the data window's corner.
class Image {
 public:
  Image() = default;
  /// All zeros. Throws Error when the size is not positive or would not fit in memory (over 2^31 floats).
  Image(int width, int height, std::vector<std::string> channels);

  int width() const { return width_; }
  int height() const { return height_; }
  Window data_window() const { return {origin_.x, origin_.y, width_, height_}; }
  /// The data window itself unless place() said otherwise.
  Window display_window() const { return display_.width > 0 ? display_ : data_window(); }
  /// Puts pixel (0, 0) at `origin` of the plane of which `display` is shown. Throws Error when `display` is empty.
  void place(Vec2i origin, const Window& display);
  std::size_t channel_count() const { return channels_.size(); }
  const std::vector<std::string>& channels() const { return channels_; }
  std::optional<std::size_t> channel(std::string_view name) const;
  bool empty() const { return pixels_.empty(); }
  /// Three or more channels, of which the first is not luminance ("Y").
  bool has_colour() const { return channels_.size() >= 3 && channels_[0] != "Y"; }

  float& at(int x, int y, std::size_t c) { return pixels_[index(x, y) + c]; }
  float at(int x, int y, std::size_t c) const { return pixels_[index(x, y) + c]; }
  /// The first three channels, or the first one thrice when there is no colour.
  Rgb rgb(int x, int y) const;
  void set_rgb(int x, int y, Rgb c);  ///< needs three channels
  std::span<float> pixels() { return pixels_; }
  std::span<const float> pixels() const { return pixels_; }
  std::span<float> row(int y) {
    return pixels().subspan(index(0, y), static_cast<std::size_t>(width_) * channel_count());
  }
  std::span<const float> row(int y) const {
    return pixels().subspan(index(0, y), static_cast<std::size_t>(width_) * channel_count());
  }

  /// Text that travels with the image ("software", "seed"): EXR string attributes, PNG tEXt.
  std::map<std::string, std::string> metadata;
  /// Values that do, by OpenEXR's names: "pixelAspectRatio", "framesPerSecond", "expTime" (seconds), "isoSpeed" ...
  std::map<std::string, Attribute> attributes;

 private:
  std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) *
           channels_.size();
  }
  int width_ = 0, height_ = 0;
  Vec2i origin_{0};
  Window display_;  // no width: the data window
  std::vector<std::string> channels_;
  std::vector<float> pixels_;
};

/// What lies in `window` of the plane, zero where the image has no data. The data window of the result is `window`,
/// its display window stays. Throws Error as the constructor does.
Image cut(Image image, const Window& window);
/// What is shown: the image cut to its display window.
Image displayed(Image image);

/// The usual names: {"R","G","B"} and with "A".
std::vector<std::string> rgb_channels();
std::vector<std::string> rgba_channels();

}  // namespace lambert
