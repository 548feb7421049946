#include "families.h"
#include "lambert/polygon/boolean/boolean.h"
#include "lambert/polygon/boolean/valid.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

namespace lambert::bench {
namespace {

using nlohmann::json;
using polygon::Ring;
using polygon::Rings;

/// TopoJSON: arcs as differences of integers, and polygons as lists of arcs; ~i is arc i backwards.
class Topology {
 public:
  explicit Topology(const json& file) {
    const json &scale = file.at("transform").at("scale"), &shift = file.at("transform").at("translate");
    for (const json& arc : file.at("arcs")) {
      Ring& points = arcs_.emplace_back();
      double x = 0, y = 0;
      for (const json& step : arc) {
        x += step.at(0).get<double>();
        y += step.at(1).get<double>();
        points.emplace_back((x * scale[0].get<double>() + shift[0].get<double>()) / 180,
                            (y * scale[1].get<double>() + shift[1].get<double>()) / 180);
      }
    }
  }

  Ring ring(const json& arcs) const {
    Ring ring;
    for (const json& index : arcs) {
      const auto i = index.get<std::int64_t>();
      Ring points = arcs_.at(static_cast<std::size_t>(i < 0 ? ~i : i));
      if (i < 0) points = Ring(points.rbegin(), points.rend());
      ring.insert(ring.end(), points.begin(), points.end() - 1);  // the last point is the next arc's first
    }
    return ring;
  }

 private:
  std::vector<Ring> arcs_;
};

Rings outer_rings(const Rings& rings) {
  Rings outer;
  for (polygon::Region& region : polygon::normalised(rings, polygon::FillRule::non_zero))
    outer.push_back(std::move(region.outer));
  return outer;
}

/// Every edge in `pieces`, their ends moved sideways by up to `rough` of their length.
Ring refined(const Ring& ring, std::size_t pieces, double rough, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-rough, rough);
  Ring finer;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d a = ring[i], step = (ring[polygon::next_index(i, ring.size())] - a) / static_cast<double>(pieces);
    finer.push_back(a);
    for (std::size_t j = 1; j < pieces; ++j)
      finer.push_back(a + static_cast<double>(j) * step + uniform(random) * Vec2d(-step.y, step.x));
  }
  return finer;
}

}  // namespace

Rings refined_land(const std::vector<Rings>& countries, std::size_t edges) {
  Rings together;
  for (const Rings& rings : countries) together.insert(together.end(), rings.begin(), rings.end());
  Rings land = outer_rings(outer_rings(together));  // the second time without islands in lakes
  const std::size_t pieces = std::max<std::size_t>(1, edges / edge_count(land));
  std::mt19937_64 random(5);
  for (Ring& ring : land) {
    const Ring finer = refined(ring, pieces, 0.3, random);
    // A sharp corner may have crossed itself.
    ring = polygon::check_valid({{finer, {}}}) ? refined(ring, pieces, 0, random) : finer;
  }
  return outer_rings(land);  // neighbours may have met
}

std::vector<Rings> countries(const std::string& file) {
  std::vector<Rings> result;
  std::ifstream stream(file);
  if (!stream) return result;
  const json root = json::parse(stream);
  const Topology topology(root);
  for (const json& geometry : root.at("objects").at("countries").at("geometries")) {
    Rings& rings = result.emplace_back();
    const json& arcs = geometry.at("arcs");
    if (geometry.at("type") == "Polygon") {
      rings.push_back(topology.ring(arcs.at(0)));
    } else {
      for (const json& polygon : arcs) rings.push_back(topology.ring(polygon.at(0)));
    }
  }
  return result;
}

}  // namespace lambert::bench
