#include "lambert/polygon/delaunay.h"

#include "lambert/polygon/predicates.h"
#include "lambert/polygon/scale.h"
#include "lambert/polygon/sorted_points.h"
#include "lambert/polygon/triangle_links.h"
#include "lambert/polygon/triangulate.h"

#include <cstddef>
#include <span>

namespace lambert::polygon {
namespace {

using Index = std::uint32_t;

Index after(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
Index before(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

/// The first index of each place, so that triangles which meet there are seen to.
void merge_places(std::span<const Vec2d> points, std::vector<Triangle>& triangles) {
  const std::vector<Index> order = sorted_left_to_right(points);
  std::vector<Index> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? first[order[i - 1]] : order[i];
  for (Triangle& t : triangles)
    for (Index& v : t) v = first[v];
}

/// Lawson's flips. The sides that have no opposite are the constraints.
class Flipper {
 public:
  Flipper(std::span<const Vec2d> points, std::vector<Triangle>& triangles)
      : points_(points), triangles_(triangles), opposite_(opposite_sides(triangles, points.size())) {}

  void run() {
    for (Index side = 0; side < opposite_.size(); ++side)
      if (opposite_[side] != no_index && side < opposite_[side]) waiting_.push_back(side);
    // Exact decisions never come back to a triangulation, nor can they flip more often.
    std::size_t flips_left = triangles_.size() * triangles_.size();
    while (!waiting_.empty() && flips_left > 0) {
      const Index side = waiting_.back();
      waiting_.pop_back();
      if (opposite_[side] == no_index || is_delaunay(side)) continue;
      flip(side);
      --flips_left;
    }
  }

 private:
  Index& corner(Index side) { return triangles_[side / 3][side % 3]; }
  Vec2d point(Index side) { return points_[corner(side)]; }

  bool is_delaunay(Index side) {
    return in_circle(point(side), point(after(side)), point(before(side)), point(before(opposite_[side]))) <= 0;
  }

  /// Triangles a b c and b a d, whose common side is a b, become d b c and c a d.
  void flip(Index side) {
    const Index other = opposite_[side], ca = before(side), db = before(other);
    corner(side) = corner(db);
    corner(other) = corner(ca);
    link(side, opposite_[db]);
    link(other, opposite_[ca]);
    link(ca, db);
    for (const Index s : {side, after(side), other, after(other)})
      if (opposite_[s] != no_index) waiting_.push_back(s);
  }
  void link(Index a, Index b) {
    opposite_[a] = b;
    if (b != no_index) opposite_[b] = a;
  }

  std::span<const Vec2d> points_;
  std::vector<Triangle>& triangles_;
  std::vector<Index> opposite_;
  std::vector<Index> waiting_;
};

}  // namespace

std::vector<Triangle> delaunay(const FlatRings& rings) {
  if (const double scale = safe_scale(sizes_of(rings.vertices)); scale != 1) return delaunay(scaled(rings, scale));
  std::vector<Triangle> triangles = triangulate(rings);
  merge_places(rings.vertices, triangles);
  Flipper(rings.vertices, triangles).run();
  return triangles;
}
std::vector<Triangle> delaunay(const Rings& rings) { return delaunay(flat(rings)); }
std::vector<Triangle> delaunay(const Region& region) { return delaunay(flat(region)); }

}  // namespace lambert::polygon
