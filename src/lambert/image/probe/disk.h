#pragma once
#include "lambert/base/vec.h"

namespace lambert::probe {

/// Between the unit square (v down) and the disk of radius 1 (y up) that touches its sides.
inline Vec2 disk_point(Vec2 uv) { return {2 * uv.x - 1, 1 - 2 * uv.y}; }
inline Vec2 disk_uv(Vec2 p) { return {0.5f + 0.5f * p.x, 0.5f - 0.5f * p.y}; }

}  // namespace lambert::probe
