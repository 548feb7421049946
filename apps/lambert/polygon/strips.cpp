#include "places.h"
#include "triangles.h"

#include "../command.h"

#include "lambert/polygon/decompose/strips.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

int run(const TriangulateOptions& o) {
  const std::vector<PolygonInput> inputs = read_inputs(o, {.validity = true});
  const Features all = joined(inputs);
  Picture picture;
  nlohmann::ordered_json features = nlohmann::json::array();
  std::string text;
  std::size_t number = 0, numbers = 0, triangles = 0;
  for (std::size_t i = 0; i < all.features.size(); ++i) {
    const FeatureTriangles mesh = triangulated(all.features[i], o);
    const Strips strips = cover_with_strips(mesh.triangles);
    nlohmann::ordered_json j{{"feature", i}, {"vertices", nlohmann::json::array()}, {"strips", strips.strips}};
    for (const Vec2d p : mesh.vertices) j["vertices"].push_back({p.x, p.y});
    features.push_back(j);
    text += describe(all.features[i], i) + ": " + counted(mesh.triangles.size(), "triangle") + " in " +
            counted(strips.strips.size(), "strip") + ", " + std::to_string(strips.vertex_count()) +
            " numbers instead of " + std::to_string(3 * mesh.triangles.size()) + "\n";
    for (const Indices& strip : strips.strips) {
      text += fmt::format("{}\n", fmt::join(strip, " "));
      Ring middles;
      for (const polygon::Triangle& t : triangles_of_strip(strip)) {
        const Ring c = corners(mesh, t);
        picture.areas.push_back({.rings = {c}, .fill = pastel(number), .edge = slate, .edge_width = 1});
        middles.push_back((c[0] + c[1] + c[2]) / 3.0);
      }
      picture.lines.push_back({.points = middles, .colour = strong(number), .arrows = true, .width = 1.6});
      ++number;
    }
    numbers += strips.vertex_count();
    triangles += mesh.triangles.size();
    add_vertex_numbers(picture, mesh);
  }
  picture.title = "strips: " + counted(triangles, "triangle") + " in " + counted(number, "strip") + ", " +
                  std::to_string(numbers) + " numbers";
  write_facts(o, {{"features", features}}, text, picture);
  return done;
}

}  // namespace

std::function<int()> add_strips(CLI::App& app) {
  static TriangulateOptions options;
  add_input_options(app, options);
  add_method(app, options);
  add_fact_outputs(app, options);
  app.footer("Triangle strips that cover a triangulation, as vertex numbers; --json adds the vertices.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
