#include "peers.h"
#include "stopwatch.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

namespace lambert::bench {
namespace {

namespace bg = boost::geometry;
using Polygons = bg::model::multi_polygon<bg::model::polygon<bg::model::d2::point_xy<double>>>;

Polygons polygons_of(const polygon::Rings& rings) {
  Polygons polygons;
  for (const polygon::Ring& ring : rings) {
    auto& outer = polygons.emplace_back().outer();
    for (const Vec2d p : ring) outer.emplace_back(p.x, p.y);
  }
  bg::correct(polygons);
  return polygons;
}

class BoostOperands final : public Operands {
 public:
  BoostOperands(const polygon::Rings& subject, const polygon::Rings& clip)
      : subject_(polygons_of(subject)), clip_(polygons_of(clip)) {}

  Run run(polygon::BooleanOp op) override {
    Stopwatch watch;
    Polygons result;
    switch (op) {
      case polygon::BooleanOp::unite: bg::union_(subject_, clip_, result); break;
      case polygon::BooleanOp::intersect: bg::intersection(subject_, clip_, result); break;
      case polygon::BooleanOp::subtract: bg::difference(subject_, clip_, result); break;
      case polygon::BooleanOp::exclude: bg::sym_difference(subject_, clip_, result); break;
    }
    return {watch.seconds(), bg::area(result), bg::num_points(result)};
  }

 private:
  Polygons subject_, clip_;
};

}  // namespace

Peer boost_peer() { return {"boost", prepared<BoostOperands>}; }

}  // namespace lambert::bench
