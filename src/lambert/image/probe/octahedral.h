#pragma once
#include "lambert/image/probe/map_point.h"

#include <optional>

namespace lambert::probe {

/// The octahedron |x| + |y| + |z| = 1 unfolded onto the square: +z in the centre, -z in the corners, x along u and y
/// along v (Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 2014).
struct Octahedral {
  static constexpr int charts = 1;
  bool operator==(const Octahedral&) const = default;

  std::optional<Vec3> direction(MapPoint at) const;
  std::optional<MapPoint> point(Vec3 d) const;
  float density(MapPoint at) const;
};

/// The equal-area octahedral map (Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD", 2008), turned as
/// pbrt-v4's: the square's centre is +z, its corners -z.
struct EqualArea {
  static constexpr int charts = 1;
  bool operator==(const EqualArea&) const = default;

  std::optional<Vec3> direction(MapPoint at) const;
  std::optional<MapPoint> point(Vec3 d) const;
  float density(MapPoint) const { return 4 * pi; }
};

/// The map itself, for uv in [0,1]² and unit directions.
Vec3 equal_area_square_to_sphere(Vec2 uv);
Vec2 equal_area_sphere_to_square(Vec3 direction);

}  // namespace lambert::probe
