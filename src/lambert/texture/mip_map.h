#pragma once
#include "lambert/base/vec.h"
#include "lambert/image/io.h"

#include <cstdint>
#include <vector>

namespace lambert {

enum class Wrap : std::uint8_t { repeat, mirror, clamp, black };
enum class TextureFilter : std::uint8_t { nearest, bilinear, trilinear };

/// An image at full and at halved sizes (odd sizes too). 8-bit images keep 8 bits per channel at level 0 and above;
/// sRGB is decoded at lookup and averaged in linear light. (u, v) = (0, 0) is the top left corner of the top left
/// texel; texel centres lie at (i + 1/2) / size.
class MipMap {
 public:
  struct Settings {
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    TextureFilter filter = TextureFilter::trilinear;
    bool srgb = false;  ///< decode colour channels from sRGB (alpha never)
  };
  MipMap(Texels texels, const Settings& settings);

  /// RGBA; one channel is spread to RGB, two are grey and alpha, missing alpha is 1. `width` is the filter's width in
  /// uv.
  Vec4 lookup(Vec2 uv, float width = 0) const;
  int width() const;
  int height() const;
  int level_count() const;
};

}  // namespace lambert
