#pragma once
#include "lambert/image/probe/cell.h"
#include "lambert/image/probe/layout.h"

#include <vector>

namespace lambert::probe {

/// Where on the chart the centre of texel (x, y) lies, or any place in pixels (texel (0, 0) begins at (0, 0)).
Vec2 uv_of(const Probe& probe, Vec2 pixel);
Vec2 pixel_of(const Probe& probe, Vec2 uv);

/// The part of the chart that texel (x, y) stands for. With edge-to-edge texels only what lies on the chart counts.
Cell texel_cell(const Probe& probe, int x, int y);

/// What a texel of each place spans; index y * width + x, the same for all charts (a cube's faces are alike).
struct TexelMeasure {
  std::vector<float> solid_angle;  ///< sr; over all charts their sum is 4π, or what a disk shows, within 1e-4
};
TexelMeasure texel_measure(const Probe& probe);

/// ∫ d dω over a texel; 0 outside of a disk. Its direction is that of the texel's middle, its length just below the
/// solid angle.
Vec3 texel_moment(const Probe& probe, int chart, int x, int y);

}  // namespace lambert::probe
