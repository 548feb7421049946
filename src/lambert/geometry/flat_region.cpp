#include "lambert/geometry/flat_region.h"

#include "lambert/base/error.h"
#include "lambert/polygon/predicates.h"
#include "lambert/polygon/triangulate.h"

#include <glm/common.hpp>

#include <algorithm>

namespace lambert {
namespace {

/// Vertices of any ring that lie on an edge become vertices of it, so that caps and sides meet edge to edge. O(n log n)
/// where few vertices lie between the ends of an edge from left to right.
void split_edges(polygon::Rings& rings) {
  const auto before = [](Vec2d a, Vec2d b) { return polygon::compare_xy(a, b) < 0; };
  std::vector<Vec2d> all;
  for (const polygon::Ring& ring : rings) all.insert(all.end(), ring.begin(), ring.end());
  std::sort(all.begin(), all.end(), before);
  for (polygon::Ring& ring : rings) {
    polygon::Ring split;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2d a = ring[i], b = ring[polygon::next_index(i, ring.size())];
      split.push_back(a);
      const auto [left, right] = std::minmax(a, b, before);
      const auto [bottom, top] = std::minmax(a.y, b.y);
      const std::size_t first = split.size();
      for (auto p = std::upper_bound(all.begin(), all.end(), left, before); p != all.end() && before(*p, right); ++p)
        if (p->y >= bottom && p->y <= top && *p != split.back() && polygon::on_segment(a, b, *p)) split.push_back(*p);
      if (before(b, a)) std::reverse(split.begin() + static_cast<std::ptrdiff_t>(first), split.end());
    }
    ring = std::move(split);
  }
}

/// Whether all lie within some of the least floats.
bool is_far_below_float(const std::vector<Vec2d>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](Vec2d p) { return std::abs(p.x) < 1e-37 && std::abs(p.y) < 1e-37; });
}

/// Of regions too small for floats, corners in one place would collapse without a word.
void check_corners(const FlatRegion& flat, const std::string& what) {
  for (const Triangle& t : flat.triangles)
    for (const auto& [i, j] : {std::pair(t[0], t[1]), std::pair(t[1], t[2]), std::pair(t[2], t[0])})
      if (Vec2(flat.vertices[i]) == Vec2(flat.vertices[j]) && is_far_below_float(flat.vertices))
        throw Error(what + ": coordinates below 1.4e-45 vanish in float, in which meshes are kept; scale them up");
}

}  // namespace

FlatRegion flat_region(const polygon::Region& region, const std::string& what) {
  FlatRegion flat;
  flat.rings = rings_of(region);
  for (std::size_t i = 0; i < flat.rings.size(); ++i) {
    polygon::Ring& ring = flat.rings[i];
    for (const Vec2d p : ring)
      if (!is_finite(Vec3(Vec2(p), 0)))
        throw Error(what + ": ring " + std::to_string(i) +
                    " has a vertex beyond 3.4e38, the range of float, in which meshes are kept");
    if ((polygon::signed_area(ring) > 0) != (i == 0)) std::reverse(ring.begin(), ring.end());
  }
  split_edges(flat.rings);
  for (const polygon::Ring& ring : flat.rings) flat.vertices.insert(flat.vertices.end(), ring.begin(), ring.end());
  flat.triangles = polygon::triangulate(flat.rings);
  if (flat.triangles.empty()) throw Error(what + ": the region has no area");
  check_corners(flat, what);

  Vec2d min = flat.vertices[0], max = min;
  for (const Vec2d p : flat.vertices) min = glm::min(min, p), max = glm::max(max, p);
  for (const Vec2d p : flat.vertices) flat.uvs.emplace_back((p - min) / (max - min));
  return flat;
}

}  // namespace lambert
