#include "places.h"

#include "../command.h"

#include "lambert/base/error.h"
#include "lambert/polygon/locate/point_locator.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

struct Options : PolygonOptions {
  std::vector<std::string> at;
  std::string points;
};

std::vector<Vec2d> query_points(const Options& o) {
  std::vector<Vec2d> points = parse_points("--at", o.at);
  if (!o.points.empty())
    for (const Vec2d p : vertices_of(read_features(o.points))) points.push_back(p);
  if (points.empty()) throw Error("contains: expected --at X,Y or --points FILE");
  return points;
}

int run(const Options& o) {
  const std::vector<Vec2d> points = query_points(o);
  const std::vector<PolygonInput> inputs = read_inputs(o, {});
  const FillRule rule = fill_rule(o);
  struct Prepared {
    PathPlace place;
    PointLocator locator;
  };
  std::vector<Prepared> prepared;
  for (const PolygonInput& input : inputs)
    for (std::size_t i = 0; i < input.features.features.size(); ++i)
      prepared.push_back({{&input, i, {}, {}, {}}, PointLocator(rings_of(input.features.features[i]))});

  Picture picture{.title = "contains"};
  show_inputs(picture, inputs, rule);
  picture.points.clear();
  picture.labels.clear();
  nlohmann::ordered_json answers = nlohmann::json::array();
  std::string text;
  for (const Vec2d p : points) {
    nlohmann::ordered_json inside = nlohmann::json::array(), on = nlohmann::json::array();
    std::string words;
    for (const Prepared& candidate : prepared) {
      const Place place = candidate.locator.locate(p, rule);
      if (place == Place::outside) continue;
      (place == Place::on ? on : inside).push_back(candidate.place.json());
      words += std::string(words.empty() ? "" : "; ") + (place == Place::on ? "on the boundary of " : "inside ") +
               candidate.place.text();
    }
    const char* where = !inside.empty() ? "inside" : (!on.empty() ? "on" : "outside");
    answers.push_back({{"at", {p.x, p.y}}, {"place", where}, {"inside", inside}, {"on", on}});
    text += point_text(p) + " " + (words.empty() ? "outside" : words) + "\n";
    const Colour colour = !inside.empty() ? Colour{26, 127, 55} : (!on.empty() ? Colour{154, 103, 0} : alarm);
    picture.points.push_back({.at = p, .colour = colour, .radius = 4});
    picture.labels.push_back({.at = p, .text = where, .colour = colour, .away = {1, 0}});
  }
  write_facts(o, {{"points", answers}}, text, picture);
  return done;
}

}  // namespace

std::function<int()> add_contains(CLI::App& app) {
  static Options options;
  add_input_options(app, options);
  add_at_option(app, options.at);
  app.add_option("--points", options.points, "Every vertex of a file")->type_name("FILE");
  add_fact_outputs(app, options);
  app.footer(
      "Decided exactly: inside, outside or on the boundary.\nExample: lambert polygon contains land.geojson --at "
      "8.5,47.4");
  return [] { return run(options); };
}

}  // namespace lambert::cli
