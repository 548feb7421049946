#include "lambert/geometry/flat_region.h"

#include "lambert/base/error.h"
#include "lambert/polygon/triangulate.h"

#include <glm/common.hpp>

#include <algorithm>

namespace lambert {

FlatRegion flat_region(const polygon::Region& region, const std::string& what) {
  FlatRegion flat;
  flat.rings = rings_of(region);
  for (std::size_t i = 0; i < flat.rings.size(); ++i) {
    polygon::Ring& ring = flat.rings[i];
    for (const Vec2d p : ring)
      if (!is_finite(Vec3(Vec2(p), 0)))
        throw Error(what + ": ring " + std::to_string(i) + " has a vertex that is not finite");
    if ((polygon::signed_area(ring) > 0) != (i == 0)) std::reverse(ring.begin(), ring.end());
    flat.vertices.insert(flat.vertices.end(), ring.begin(), ring.end());
  }
  flat.triangles = polygon::triangulate(flat.rings);
  if (flat.triangles.empty()) throw Error(what + ": the region has no area");

  Vec2d min = flat.vertices[0], max = min;
  for (const Vec2d p : flat.vertices) min = glm::min(min, p), max = glm::max(max, p);
  for (const Vec2d p : flat.vertices) flat.uvs.emplace_back((p - min) / (max - min));
  return flat;
}

}  // namespace lambert
