#pragma once
#include "lambert/base/bounds.h"
#include "lambert/base/vec.h"

#include <cmath>

namespace lambert {

/// The angle of (x, y) about the z axis, in [0, 2π].
inline float azimuth(float x, float y) {
  const float phi = std::atan2(y, x);
  return phi < 0 ? phi + 2 * pi : phi;
}

/// ∂p/∂u of a surface of revolution about z whose u runs over [0, phi_max]. On the axis, where it vanishes, the
/// direction of φ = 0 stays.
inline Vec3 azimuth_derivative(Vec3 p, float phi_max) {
  return p.x == 0 && p.y == 0 ? Vec3(0, 1e-5f * phi_max, 0) : phi_max * Vec3(-p.y, p.x, 0);
}

/// Of the points at z in [z_min, z_max], at a distance in [inner, outer] from the z axis, at an azimuth in
/// [0, phi_max].
Bounds3 sector_bounds(float inner, float outer, float phi_max, float z_min, float z_max);

}  // namespace lambert
