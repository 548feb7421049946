#include "lambert/geometry/extrude.h"

#include "lambert/base/error.h"
#include "lambert/geometry/flat_region.h"

#include <cmath>

namespace lambert {
namespace {

void add_prism(TriangleMesh& mesh, const polygon::Region& region, const Extrusion& extrusion) {
  const FlatRegion flat = flat_region(region, "extrude");
  // From the lower plane to the upper one, whichever way the region moves.
  const Vec3d base = extrusion.along.z < 0 ? extrusion.along : Vec3d(0), rise = extrusion.along - 2.0 * base;
  const auto place = [&](Vec2d p, bool upper) { return Vec3(Vec3d(p, 0) + base + (upper ? rise : Vec3d(0))); };

  std::size_t first = 0;
  for (const polygon::Ring& ring : flat.rings) {
    std::vector<ProfileSegment> segments;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = polygon::next_index(i, ring.size());
      const Vec3d edge(ring[j] - ring[i], 0), across = cross(edge, rise);
      const double size = length(across);
      if (!(size > 0)) continue;
      segments.push_back({first + i, first + j, length(edge), across / size, across / size});
    }
    // Columns run downward, so that what faces column times row faces outward.
    add_strips(mesh, swept_profile(segments, true, extrusion.crease), 1,
               [&](const ProfileRow& row, std::uint32_t column) {
                 return SweptVertex{place(flat.vertices[row.point], column == 0), Vec3(row.normal),
                                    Vec2(static_cast<float>(row.along), column == 0 ? 1 : 0)};
               });
    first += ring.size();
  }
  for (const bool upper : {false, true}) {
    std::vector<Vec3> positions;
    for (const Vec2d p : flat.vertices) positions.push_back(place(p, upper));
    add_cap(mesh, positions, flat.uvs, flat.triangles, {0, 0, upper ? 1 : -1}, !upper);
  }
}

void check(const Extrusion& extrusion) {
  if (!is_finite(Vec3(extrusion.along)) || Vec3(extrusion.along).z == 0)
    throw Error("extrude: expected a finite direction that leaves the plane z = 0");
}

}  // namespace

TriangleMesh extrude(const polygon::Region& region, const Extrusion& extrusion) {
  check(extrusion);
  TriangleMesh mesh;
  add_prism(mesh, region, extrusion);
  return mesh;
}

TriangleMesh extrude(const polygon::Regions& regions, const Extrusion& extrusion) {
  check(extrusion);
  TriangleMesh mesh;
  for (const polygon::Region& region : regions) add_prism(mesh, region, extrusion);
  return mesh;
}

SolidCounts extrusion_counts(const polygon::Region& region) {
  std::size_t n = region.outer.size();
  for (const polygon::Ring& hole : region.holes) n += hole.size();
  return {.vertices = 2 * n, .quads = n, .caps = 2};
}

}  // namespace lambert
