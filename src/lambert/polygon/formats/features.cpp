#include "lambert/polygon/formats/features.h"

#include "lambert/base/number.h"

namespace lambert::polygon {
namespace {

void append_rings(const Feature& feature, Rings& rings) {
  for (const PathPolygon& polygon : feature.polygons)
    for (const Path& ring : polygon) rings.push_back(ring.points);
}

void append(const Path& path, std::vector<Vec2d>& vertices) {
  vertices.insert(vertices.end(), path.points.begin(), path.points.end());
}

}  // namespace

Rings rings_of(const Feature& feature) {
  Rings rings;
  append_rings(feature, rings);
  return rings;
}

Rings rings_of(const Features& features) {
  Rings rings;
  for (const Feature& feature : features.features) append_rings(feature, rings);
  return rings;
}

std::vector<Vec2d> vertices_of(const Features& features) {
  std::vector<Vec2d> vertices;
  for (const Feature& feature : features.features) {
    append(feature.points, vertices);
    for (const Path& line : feature.lines) append(line, vertices);
    for (const PathPolygon& polygon : feature.polygons)
      for (const Path& ring : polygon) append(ring, vertices);
  }
  return vertices;
}

std::vector<PathPolygon> polygons_of(const Regions& regions) {
  std::vector<PathPolygon> polygons;
  for (const Region& region : regions) {
    PathPolygon& polygon = polygons.emplace_back();
    for (Ring& ring : rings_of(region)) polygon.push_back({.points = std::move(ring), .heights = {}});
  }
  return polygons;
}

std::vector<PathPolygon> polygons_of(const Rings& rings) {
  std::vector<PathPolygon> polygons;
  for (const Ring& ring : rings) polygons.push_back({{.points = ring, .heights = {}}});
  return polygons;
}

std::string describe(const Feature& feature, std::size_t index) {
  const std::string number = "feature " + std::to_string(index);
  return feature.name.empty() ? number : number + " '" + printable(feature.name) + "'";
}

}  // namespace lambert::polygon
