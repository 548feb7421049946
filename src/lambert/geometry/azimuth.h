#pragma once
#include "lambert/base/vec.h"

#include <cmath>

namespace lambert {

/// The angle of (x, y) about the z axis, in [0, 2π].
inline float azimuth(float x, float y) {
  const float phi = std::atan2(y, x);
  return phi < 0 ? phi + 2 * pi : phi;
}

}  // namespace lambert
