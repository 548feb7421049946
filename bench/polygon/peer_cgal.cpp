#include "peers.h"
#include "stopwatch.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <algorithm>
#include <iterator>

namespace lambert::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;

PolygonSet::Polygon_2 polygon_of(const polygon::Ring& ring) {
  PolygonSet::Polygon_2 polygon;
  for (const Vec2d p : ring) polygon.push_back({p.x, p.y});
  return polygon;
}

bool all_simple(const polygon::Rings& rings) {
  return std::all_of(rings.begin(), rings.end(),
                     [](const polygon::Ring& ring) { return polygon_of(ring).is_simple(); });
}

PolygonSet set_of(const polygon::Rings& rings) {
  std::vector<PolygonSet::Polygon_2> polygons;
  for (const polygon::Ring& ring : rings) {
    PolygonSet::Polygon_2& polygon = polygons.emplace_back(polygon_of(ring));
    if (polygon.is_clockwise_oriented()) polygon.reverse_orientation();
  }
  PolygonSet set;
  set.join(polygons.begin(), polygons.end());
  return set;
}

polygon::Ring ring_of(const PolygonSet::Polygon_2& polygon) {
  polygon::Ring ring;
  for (const auto& p : polygon.container()) ring.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  return ring;
}

class CgalOperands final : public Operands {
 public:
  CgalOperands(const polygon::Rings& subject, const polygon::Rings& clip)
      : subject_(set_of(subject)), clip_(set_of(clip)) {}

  Run run(polygon::BooleanOp op) override {
    Stopwatch watch;
    PolygonSet result;
    switch (op) {
      case polygon::BooleanOp::unite: result.join(subject_, clip_); break;
      case polygon::BooleanOp::intersect: result.intersection(subject_, clip_); break;
      case polygon::BooleanOp::subtract: result.difference(subject_, clip_); break;
      case polygon::BooleanOp::exclude: result.symmetric_difference(subject_, clip_); break;
    }
    Run run{.seconds = watch.seconds()};
    std::vector<PolygonSet::Polygon_with_holes_2> pieces;
    result.polygons_with_holes(std::back_inserter(pieces));
    for (const auto& piece : pieces) {
      polygon::Rings rings{ring_of(piece.outer_boundary())};
      for (const auto& hole : piece.holes()) rings.push_back(ring_of(hole));
      run.area += polygon::signed_area(rings);
      for (const polygon::Ring& ring : rings) run.vertices += ring.size();
    }
    return run;
  }

 private:
  PolygonSet subject_, clip_;
};

}  // namespace

Peer cgal_peer() {
  return {"cgal", [](const polygon::Rings& subject, const polygon::Rings& clip) -> std::unique_ptr<Operands> {
            // What is not simple ends the process.
            if (!all_simple(subject) || !all_simple(clip)) return nullptr;
            return prepared<CgalOperands>(subject, clip);
          }};
}

}  // namespace lambert::bench
