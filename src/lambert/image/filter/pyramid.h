#pragma once
#include "lambert/base/vec.h"
#include "lambert/image/filter/footprint.h"
#include "lambert/image/filter/lookup.h"
#include "lambert/image/image.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lambert {

enum class LookupMethod {
  nearest,      ///< the texel of level 0
  bilinear,     ///< four texels of level 0
  trilinear,    ///< two levels around log2 of the pixel's largest edge (rows AA-21, AA-22)
  anisotropic,  ///< the ellipse that the pixel covers (Heckbert 1989), from the levels that suit its short axis
};
LookupMethod lookup_method(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> lookup_method_names();

struct LookupSettings {
  LookupMethod method = LookupMethod::trilinear;
  EdgeModes edges;
  float max_anisotropy = 16;  ///< a longer ellipse is made thicker, so that a lookup costs at most some 200 fetches
};

/// Row AA-20: an image and its copies at halved sizes down to one pixel, in 4/3 of the memory. A size that is odd is
/// halved downwards, every pixel counting by its area; so all levels have the same mean. All channels are kept.
class Pyramid {
 public:
  explicit Pyramid(Image base);
  /// From levels that exist. Throws Error unless each has half the size of the one before and the last is one pixel.
  explicit Pyramid(std::vector<Image> levels);

  int level_count() const { return static_cast<int>(levels_.size()); }
  const Image& level(int i) const { return levels_[static_cast<std::size_t>(i)]; }
  std::size_t value_count() const;  ///< of all levels and channels

  /// RGBA at a place in uv, seen by a pixel that covers `footprint`. Channels that are no R, G, B are left out; an
  /// image without colour gives its first channel thrice; missing alpha is 1, black outside has alpha 0.
  Vec4 lookup(Vec2 uv, const Footprint& footprint = {}, const LookupSettings& settings = {}) const;

 private:
  void find_alpha();
  Vec4 texel(const Image& level, int x, int y) const;
  std::vector<Image> levels_;
  int alpha_ = -1;
};

/// Half the size, downwards but at least 1, each pixel counting by its area.
Image halved(const Image& image);

/// The notes' packed map (after Williams 1983): a grey image of twice the size, of whose quarters the top left is the
/// red separation, the top right the green, the bottom left the blue one, and the bottom right the next level packed
/// the same way; one corner texel remains, 0. Throws Error unless the base is a square of 2ⁿ with R, G and B.
Image packed(const Pyramid& pyramid);
/// The pyramid of a packed map. Throws Error unless it is a square of 2ⁿ, n > 0.
Pyramid unpacked(const Image& packed);

}  // namespace lambert
