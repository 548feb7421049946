#pragma once
/// Weights of non-local means (Buades, Coll and Morel 2005) for noise of known variance (Rousselle, Knaus and Zwicker,
/// "Adaptive Rendering with Non-Local Means Filtering", 2012, section 4): pixels p and q are as alike as the patches
/// around them,
///   d²(p, q) = Σ over channels of ((p - q)² - (v_p + min(v_p, v_q))) / (ε + v_p + v_q),
/// averaged over channels and patch; the weight is exp(-max(0, d²) / k²). The squared differences of the pixels
/// themselves in further planes, the axes, may be added to the exponent, as in the bilateral filter.

#include "lambert/image/denoise/plane.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lambert::denoise {

/// Pixels and variances that patches are compared by: 1 to 3 channels.
class PatchGuide {
 public:
  /// For windows and patches of these radii.
  PatchGuide(std::span<const Plane> values, std::span<const Plane> variances, int window_radius, int patch_radius,
             std::span<const Plane> axes = {});
  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t channels() const { return values_.size(); }
  const float* value(std::size_t c, int y) const { return values_[c].row(y); }
  const float* variance(std::size_t c, int y) const { return variances_[c].row(y); }
  std::span<const PaddedPlane> axes() const { return axes_; }

 private:
  int width_, height_;
  std::vector<PaddedPlane> values_, variances_, axes_;
};

constexpr int tile_size = 32;

/// One of the squares that a picture is cut into.
struct Tile {
  int x = 0, y = 0;  ///< of its corner
};
/// All tiles of a picture, row by row.
std::vector<Tile> tiles_of(int width, int height);

/// d² and then exp(-max(0, d²) sharpness - axes) for the pixels of one tile, or every second one in both directions,
/// and one offset of their partners.
class TileWeights {
 public:
  /// `stride` is 1 or 2; `patch_radius` is 0 to 3.
  TileWeights(const PatchGuide& guide, Tile tile, int stride, int patch_radius, float sharpness);

  int side() const { return tile_size / stride_; }  ///< pixels a row
  /// The weights of pixel (tile.x + stride i, tile.y + stride j) with its partner (dx, dy) further, at j side() + i.
  /// Zero where either is outside the picture.
  const float* at(int dx, int dy);

 private:
  static constexpr int most_patch_radius = 3, rows = tile_size + 2 * most_patch_radius, columns = 48;
  void compare(int dx, int dy, std::size_t channel);

  const PatchGuide& guide_;
  Tile tile_;
  int stride_, patch_radius_;
  float scale_;
  std::array<std::array<float, columns>, rows> distance_;
  std::array<std::array<float, tile_size>, rows> across_;
  std::array<float, tile_size * tile_size> weights_;
};

}  // namespace lambert::denoise
