#pragma once
#include "lambert/base/angle.h"
#include "lambert/geometry/mesh.h"
#include "lambert/geometry/swept_profile.h"
#include "lambert/polygon/ring.h"

namespace lambert {

struct Extrusion {
  Vec3d along{0, 0, 1};        ///< need not be upright
  Angle crease = degrees(30);  ///< sides that turn by less look smooth
};

/// The prism that a region of the plane z = 0 leaves when it moves by `along`: two triangles for each edge, and two
/// caps, with holes. Closed (is_closed()) when rings touch themselves and each other in common vertices at most. uv of
/// the sides: along the ring and along the movement; of the caps: the place in the bounding box.
/// Throws Error when `along` lies in the plane, something is not finite or the region has no area. O(n log n).
TriangleMesh extrude(const polygon::Region& region, const Extrusion& extrusion = {});

/// All in one mesh.
TriangleMesh extrude(const polygon::Regions& regions, const Extrusion& extrusion = {});

/// Vertices, side quads and caps of the prism.
SolidCounts extrusion_counts(const polygon::Region& region);

}  // namespace lambert
