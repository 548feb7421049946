#include "places.h"

#include <nlohmann/json.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

std::string PathPlace::text() const {
  std::string words = input->name + ": " + describe(feature_of(), feature);
  if (polygon && feature_of().polygons.size() > 1) words += ", polygon " + std::to_string(*polygon);
  if (ring) words += ", ring " + std::to_string(*ring);
  if (line) words += ", line " + std::to_string(*line);
  return words;
}

nlohmann::ordered_json PathPlace::json() const {
  nlohmann::ordered_json j{{"file", input->name}, {"feature", feature}};
  if (!feature_of().name.empty()) j["name"] = feature_of().name;
  if (polygon) j["polygon"] = *polygon;
  if (ring) j["ring"] = *ring;
  if (line) j["line"] = *line;
  return j;
}

std::vector<Vec3d> in_space(const Path& path) {
  std::vector<Vec3d> vertices;
  for (std::size_t i = 0; i < path.points.size(); ++i)
    vertices.emplace_back(path.points[i].x, path.points[i].y, path.heights.empty() ? 0.0 : path.heights[i]);
  return vertices;
}

void show_inputs(Picture& picture, const std::vector<PolygonInput>& inputs, FillRule rule) {
  std::size_t index = 0;
  for (const PolygonInput& input : inputs)
    for (const Feature& feature : input.features.features) {
      const Rings rings = rings_of(feature);
      if (!rings.empty())
        picture.areas.push_back(
            {.rings = rings, .rule = rule, .fill = pastel(index).with_opacity(0.55), .edge = strong(index)});
      add_indices(picture, rings, ink);
      for (const Path& line : feature.lines) {
        picture.lines.push_back({.points = line.points, .colour = strong(index)});
        add_indices(picture, {line.points}, ink);
      }
      for (const Vec2d p : feature.points.points) picture.points.push_back({.at = p, .colour = strong(index)});
      ++index;
    }
}

void show_pieces(Picture& picture, const std::vector<Rings>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    picture.areas.push_back({.rings = pieces[i], .fill = pastel(i), .edge = slate, .edge_width = 1});
    if (pieces.size() > 200 || pieces[i].empty() || pieces[i][0].empty()) continue;
    Vec2d mean(0);
    for (const Vec2d p : pieces[i][0]) mean += p / static_cast<double>(pieces[i][0].size());
    if (pieces[i].size() == 1) picture.labels.push_back({.at = mean, .text = std::to_string(i), .colour = strong(i)});
  }
}

}  // namespace lambert::cli
