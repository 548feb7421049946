#include "places.h"

#include "../command.h"
#include "../number_range.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/polygon/queries/pick.h"
#include "lambert/polygon/queries/segment.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <limits>
#include <optional>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

struct Options : PolygonOptions {
  std::vector<std::string> at;
  std::string window, viewport = "640x640";
  double radius = 8, width = 6;
  bool units = false;
};

struct Picked {
  PathPlace place;
  std::size_t edge;
  double distance;
};

std::optional<Picked> nearest(const std::vector<PolygonInput>& inputs, const GravityField& field, Vec2d p) {
  std::optional<Picked> best;
  for_each_path(inputs, [&](const PathPlace& place, const Path& path) {
    const std::size_t n = path.points.size(), edges = place.ring || n == 0 ? n : n - 1;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vec2d a = path.points[i], b = path.points[next_index(i, n)];
      if (!is_picked(field, a, b, p)) continue;
      const double distance = distance_to_segment(a, b, p);
      if (!best || distance < best->distance) best = Picked{place, i, distance};
    }
  });
  return best;
}

int run(const Options& o) {
  if (!(o.radius > o.width / 2)) throw Error("pick: expected a --radius of more than half the --width");
  if (o.at.empty()) throw Error("pick: expected --at X,Y");
  const std::vector<Vec2d> points = parse_points("--at", o.at);
  const std::vector<PolygonInput> inputs = read_inputs(o, {.lines = true});
  const Vec2i size = parse_size("--viewport", o.viewport);
  const Box2 window = o.window.empty() ? box_of(vertices_of(joined(inputs))) : parse_window("--window", o.window);
  if (window.empty()) throw Error("pick: there is nothing to pick");
  const GravityField field =
      o.units ? GravityField{o.radius, o.width} : field_of_pixels(o.radius, o.width, window, {{0, 0}, Vec2d(size)});

  Picture picture{.title = "pick"};
  show_inputs(picture, inputs);
  nlohmann::ordered_json answers = nlohmann::json::array();
  std::string text;
  for (const Vec2d p : points) {
    const auto picked = nearest(inputs, field, p);
    nlohmann::ordered_json j{{"at", {p.x, p.y}}, {"picked", nullptr}};
    text += point_text(p) + " picks ";
    picture.points.push_back({.at = p, .colour = alarm, .shape = Picture::Shape::cross, .radius = 4});
    if (picked) {
      j["picked"] = picked->place.json();
      j["picked"]["edge"] = picked->edge;
      j["picked"]["distance"] = picked->distance;
      text += "edge " + std::to_string(picked->edge) + " of " + picked->place.text() + ", at a distance of " +
              number_text(picked->distance) + "\n";
      const Feature& feature = picked->place.feature_of();
      const Ring& path = picked->place.line ? feature.lines[*picked->place.line].points
                                            : feature.polygons[*picked->place.polygon][*picked->place.ring].points;
      picture.lines.push_back(
          {.points = {path[picked->edge], path[next_index(picked->edge, path.size())]}, .colour = alarm, .width = 3});
    } else {
      text += "nothing\n";
    }
    answers.push_back(j);
  }
  write_facts(o, {{"field", {{"radius", field.radius}, {"width", field.width}}}, {"points", answers}}, text, picture);
  return done;
}

}  // namespace

std::function<int()> add_pick(CLI::App& app) {
  static Options options;
  add_input_options(app, options, false);
  add_at_option(app, options.at);
  const NumberRange above_zero{.expected = "a finite number above 0", .low = std::numeric_limits<double>::denorm_min()};
  expect_number(
      app.add_option("--radius", options.radius, "Of the disks about the ends, in pixels")->capture_default_str(),
      above_zero);
  expect_number(
      app.add_option("--width", options.width, "Of the rectangle along the edge, from side to side, in pixels")
          ->capture_default_str(),
      above_zero);
  app.add_option("--viewport", options.viewport, "The pixels that show the window")->capture_default_str();
  app.add_option("--window", options.window, "What is seen, x0,y0,x1,y1; the box of the data by default");
  app.add_flag("--units", options.units, "Radius and width are in the data's units, whatever the viewport");
  add_fact_outputs(app, options);
  app.footer("Picks the nearest edge whose gravity field holds the point: two disks and a rectangle.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
