#pragma once
#include "lambert/image/probe/cell.h"
#include "lambert/image/probe/layout.h"

#include <optional>
#include <vector>

namespace lambert::probe {

/// Where on the chart the centre of texel (x, y) lies, or any place in pixels (texel (0, 0) begins at (0, 0)).
Vec2 uv_of(const Probe& probe, Vec2 pixel);
Vec2 pixel_of(const Probe& probe, Vec2 uv);

struct Texel {
  int chart = 0, x = 0, y = 0;
};
/// The texel `step` away: on the sphere where the chart ends, none beyond the rim of a disk.
std::optional<Texel> neighbour(const Probe& probe, const Texel& texel, Vec2i step);
/// The texel that shows a direction, if one does.
std::optional<Texel> texel_at(const Probe& probe, Vec3 direction);

/// The part of the chart that texel (x, y) stands for. With edge-to-edge texels only what lies on the chart counts.
Cell texel_cell(const Probe& probe, int x, int y);

/// integrals() over texels, of lat-long maps from tables of rows and columns.
class TexelIntegrals {
 public:
  explicit TexelIntegrals(const Probe& probe);
  CellIntegrals operator()(int chart, int x, int y) const {
    if (rows_.empty()) return integrals(probe_->projection, chart, texel_cell(*probe_, x, y));
    return integrals(rows_[static_cast<std::size_t>(y)], columns_[static_cast<std::size_t>(x)]);
  }

 private:
  const Probe* probe_;
  std::vector<LatLongRow> rows_;
  std::vector<LatLongColumn> columns_;
};

/// What a texel of each place spans; index y * width + x, the same for all charts (a cube's faces are alike).
struct TexelMeasure {
  std::vector<float> solid_angle;  ///< sr; over all charts their sum is 4π, or what a disk shows, within 1e-4
};
TexelMeasure texel_measure(const Probe& probe);

/// ∫ d dω over a texel; 0 outside of a disk. Its direction is that of the texel's middle, its length just below the
/// solid angle.
Vec3 texel_moment(const Probe& probe, int chart, int x, int y);

}  // namespace lambert::probe
