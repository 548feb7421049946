#pragma once
#include "lambert/image/probe/layout.h"

#include <vector>

namespace lambert::probe {

/// Where on the chart the centre of texel (x, y) lies, or any place in pixels (texel (0, 0) begins at (0, 0)).
Vec2 uv_of(const Probe& probe, Vec2 pixel);
Vec2 pixel_of(const Probe& probe, Vec2 uv);

/// What a texel of each place spans; index y * width + x, the same for all charts (a cube's faces are alike).
struct TexelMeasure {
  std::vector<float> solid_angle;  ///< sr; over all charts their sum is 4π, or what a fisheye sees, within 1e-4
};
/// Closed forms for lat-long, cube and equal-area maps, else Gauss' rule with 2x2 points, at the rim of a disk an even
/// grid of 32x32. With edge-to-edge texels only what lies on the chart counts.
TexelMeasure texel_measure(const Probe& probe);

/// ∫ d dω over a texel, by its closed form for lat-long maps, else by Gauss' rule with 2x2 points; 0 outside of a disk.
/// Its direction is that of the texel's middle, its length just below the solid angle.
Vec3 texel_moment(const Probe& probe, int chart, int x, int y, float solid_angle);

}  // namespace lambert::probe
