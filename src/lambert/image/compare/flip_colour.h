#pragma once
/// The colour spaces of FLIP (Andersson et al. 2020, section 4.1) for a white of linear RGB (1, 1, 1).

#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"

#include <numbers>

namespace lambert::compare {

inline constexpr double pi_double = std::numbers::pi, pi_squared = std::numbers::pi * std::numbers::pi;

/// Linear RGB to YCxCz: a linear opponent space whose first channel is 116 Y - 16 for white Y = 1.
Vec3 opponent(Rgb rgb);

/// YCxCz, filtered, to L*a*b* with a* and b* scaled by 0.01 L* (the Hunt effect); clipped to what a screen shows.
Vec3 hunt_lab(Vec3 opponent);

/// The HyAB distance to the power 0.7, compressed to [0, 1]: differences up to 0.4 of that from green to blue take
/// [0, 0.95].
float colour_error(Vec3 a, Vec3 b);

}  // namespace lambert::compare
