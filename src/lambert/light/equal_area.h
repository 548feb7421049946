#pragma once
#include "lambert/base/vec.h"

namespace lambert {

/// The equal-area octahedral map between the unit square and the sphere (Clarberg, "Fast Equal-Area Mapping of the
/// (Hemi)Sphere using SIMD", 2008): the square's centre is +z, its corners -z.
Vec3 equal_area_square_to_sphere(Vec2 uv);
Vec2 equal_area_sphere_to_square(Vec3 direction);

}  // namespace lambert
