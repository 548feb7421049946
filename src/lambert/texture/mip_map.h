#pragma once
#include "lambert/base/vec.h"
#include "lambert/image/filter/edge_mode.h"
#include "lambert/image/io.h"

#include <cstdint>
#include <vector>

namespace lambert {

enum class TextureFilter : std::uint8_t { nearest, bilinear, trilinear };

/// An image at full and at halved sizes (odd sizes too: every texel of a level counts by its area). 8-bit images keep 8
/// bits per channel at all levels; sRGB is decoded at lookup and averaged in linear light. (u, v) = (0, 0) is the top
/// left corner of the top left texel; texel centres lie at (i + 1/2) / size.
class MipMap {
 public:
  struct Settings {
    EdgeMode wrap_u = EdgeMode::repeat, wrap_v = EdgeMode::repeat;
    TextureFilter filter = TextureFilter::trilinear;
    bool srgb = false;  ///< decode colour channels from sRGB (alpha never, linear floats never)
  };
  MipMap(Texels texels, const Settings& settings);

  /// RGBA; one channel is spread to RGB, two are grey and alpha, missing alpha is 1. `width` is the filter's width in
  /// uv. Coordinates that are not finite give the same as 0.
  Vec4 lookup(Vec2 uv, float width = 0) const;
  int width() const { return levels_[0].width; }
  int height() const { return levels_[0].height; }
  int level_count() const { return static_cast<int>(levels_.size()); }
  /// The texel of a level, decoded; inside the image.
  Vec4 texel(int level, int x, int y) const { return fetch(levels_[static_cast<std::size_t>(level)], x, y); }

 private:
  struct Level {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;
    std::vector<float> floats;
  };
  Level halved(const Level& from) const;
  Vec4 fetch(const Level& level, int x, int y) const;
  bool is_colour(int channel) const { return channel < 3 && !(channels_ == 2 && channel == 1); }

  std::vector<Level> levels_;
  Settings settings_;
  int channels_ = 0;
};

}  // namespace lambert
