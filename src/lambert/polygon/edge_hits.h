#pragma once
/// Which edges of a polygon a line, a ray or a segment meets, and which first (PG-49).

#include "lambert/polygon/box.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lambert::polygon {

/// How far the line through a and b counts.
enum class Reach : std::uint8_t {
  line,     ///< in both directions
  ray,      ///< from a over b and on, a included
  segment,  ///< from a to b, both included
};

struct EdgeHit {
  std::size_t ring, edge;
  double t, t_to;  ///< 0 at a, 1 at b; they differ only for an edge that lies along the line
  Vec2d point, to;
  bool operator==(const EdgeHit&) const = default;
};

/// The real hits, in order along the line; equal places by ring and edge. An edge counts without its end, so that a
/// vertex on the line is met once: by the edge that starts there (PG-11). An edge along the line is one hit, from its
/// first to its last point within reach. a and b differ, else there are none. Which edges are met and their order are
/// decided exactly; points are rounded (see LineOrder). O(n + k log k) for k hits.
std::vector<EdgeHit> edge_hits(const Rings& rings, Vec2d a, Vec2d b, Reach reach);

/// The first of edge_hits(); that of the lowest ring and edge when several are. O(n).
std::optional<EdgeHit> first_edge_hit(const Rings& rings, Vec2d a, Vec2d b, Reach reach = Reach::ray);

/// The same answers by a hierarchy of boxes over the edges, for polygons of many edges. Building takes O(n log n).
class EdgeTree {
 public:
  explicit EdgeTree(const Rings& rings);
  std::vector<EdgeHit> edge_hits(Vec2d a, Vec2d b, Reach reach) const;
  std::optional<EdgeHit> first_edge_hit(Vec2d a, Vec2d b, Reach reach = Reach::ray) const;

 private:
  struct Edge {
    Vec2d from, to;
    std::size_t ring, index;
  };
  struct Node {
    Box2 box;
    std::uint32_t first, count;  ///< of its edges
    std::uint32_t second;        ///< its second child; 0 for a leaf, whose first child would be the next node
  };
  std::uint32_t build(std::uint32_t first, std::uint32_t count);
  struct Query {
    Vec2d a, b;
    Reach reach;
    double factor;  ///< for edges_ and nodes_, to meet a and b
    double scale;   ///< what a, b and the edges then are multiplied by
  };
  Query query(Vec2d a, Vec2d b, Reach reach) const;
  template <class Use>
  void visit(const Query& query, Use use) const;

  double scale_;  ///< what edges_ and nodes_ were multiplied by
  std::vector<Edge> edges_;
  std::vector<Node> nodes_;
};

}  // namespace lambert::polygon
