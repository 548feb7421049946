#pragma once
#include "lambert/geometry/mesh.h"
#include "lambert/polygon/ring.h"

#include <string>
#include <vector>

namespace lambert {

/// A region ready for caps: vertices ring after ring, outer ring counter-clockwise first, holes clockwise.
struct FlatRegion {
  polygon::Rings rings;
  std::vector<Vec2d> vertices;
  std::vector<Vec2> uvs;  ///< the place in the bounding box, in [0, 1]²
  std::vector<Triangle> triangles;
};

/// Turns rings to their orientation. Throws Error, which begins with `what`, when a coordinate is not finite as a float
/// or nothing is enclosed.
FlatRegion flat_region(const polygon::Region& region, const std::string& what);

}  // namespace lambert
