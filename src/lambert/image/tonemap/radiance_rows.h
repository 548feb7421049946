#pragma once
#include "lambert/image/image.h"
#include "lambert/image/tonemap/luminance_map.h"

#include <optional>
#include <vector>

namespace lambert::tone {

/// One row of colours apart, without alpha's factor.
struct ColourRow {
  explicit ColourRow(int width) : r(static_cast<std::size_t>(width)), g(r), b(r), alpha(r) {}
  std::vector<float> r, g, b, alpha;
};

/// out = the luminance of each pixel.
void luminances(const ColourRow& row, float* out);

/// An image as operators want it: colours divided by alpha, scaled, without NaN, negative or infinite numbers.
class RadianceRows {
 public:
  explicit RadianceRows(const Image& image) : image_(&image), alpha_(image.channel("A")) {}
  const Image& image() const { return *image_; }
  bool has_alpha() const { return alpha_.has_value(); }
  void load(int y, float scale, ColourRow& row) const;
  LuminanceMap luminance_map(float scale) const;
  /// The same without the luminances.
  LuminanceMap statistics(float scale) const;
  RgbPlanes planes(float scale) const;

 private:
  LuminanceMap measured(float scale, bool keep) const;

  const Image* image_;
  std::optional<std::size_t> alpha_;
};

}  // namespace lambert::tone
