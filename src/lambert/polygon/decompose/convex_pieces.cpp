#include "lambert/polygon/decompose/convex_pieces.h"

#include "lambert/polygon/decompose/delaunay.h"
#include "lambert/polygon/decompose/trapezoids.h"
#include "lambert/polygon/decompose/triangle_links.h"
#include "lambert/polygon/predicates/predicates.h"

#include <cstddef>

namespace lambert::polygon {

std::vector<std::vector<std::uint32_t>> joined_to_convex(std::span<const Vec2d> vertices,
                                                         std::span<const Triangle> triangles) {
  using Index = std::uint32_t;
  const std::vector<Index> opposite = opposite_sides(triangles, vertices.size());
  const auto sides = static_cast<Index>(opposite.size());
  std::vector<Index> after(sides), before(sides);
  for (Index s = 0; s < sides; ++s) {
    after[s] = s % 3 == 2 ? s - 2 : s + 1;
    before[after[s]] = s;
  }
  const auto start = [&](Index side) { return triangles[side / 3][side % 3]; };
  const auto convex = [&](Index arriving, Index leaving) {
    return orientation(vertices[start(arriving)], vertices[start(leaving)], vertices[start(after[leaving])]) >= 0;
  };
  std::vector<bool> removed(sides, false);
  for (Index s = 0; s < sides; ++s) {
    const Index o = opposite[s];
    if (o == no_index || o < s) continue;
    if (!convex(before[s], after[o]) || !convex(before[o], after[s])) continue;
    removed[s] = removed[o] = true;
    const auto link = [&](Index a, Index b) { after[a] = b, before[b] = a; };
    const Index into_start = before[s], into_end = before[o];
    link(into_start, after[o]);
    link(into_end, after[s]);
  }

  std::vector<std::vector<Index>> pieces;
  for (Index s = 0; s < sides; ++s) {
    if (removed[s]) continue;
    std::vector<Index>& piece = pieces.emplace_back();
    for (Index at = s; !removed[at]; at = after[at]) {
      removed[at] = true;
      piece.push_back(start(at));
    }
  }
  return pieces;
}

std::vector<Ring> convex_pieces(const Region& region, ConvexMethod method) {
  std::vector<Ring> pieces;
  const FlatRings rings = flat(region);
  if (method == ConvexMethod::trapezoids) {
    trapezoids(rings, [&](const Trapezoid& t) {
      pieces.emplace_back(t.corners.begin(), t.corners.begin() + static_cast<std::ptrdiff_t>(t.size));
    });
    return pieces;
  }
  for (const auto& piece : joined_to_convex(rings.vertices, delaunay(rings))) {
    Ring& ring = pieces.emplace_back();
    for (const std::uint32_t v : piece) ring.push_back(rings.vertices[v]);
  }
  return pieces;
}

}  // namespace lambert::polygon
