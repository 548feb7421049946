#include "places.h"

#include "../command.h"

#include "lambert/polygon/boolean/boolean.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

/// The first file with the second, the result with the third, and so on; one file alone is united with nothing.
Regions combined(BooleanOp op, const std::vector<PolygonInput>& inputs, FillRule rule, const FractionSink& progress) {
  Regions result = normalised(rings_of(inputs.front().features), rule);
  for (std::size_t i = 1; i < inputs.size(); ++i) {
    if (progress) progress(static_cast<double>(i) / static_cast<double>(inputs.size()));
    result =
        boolean(op, rings_of(result), rings_of(normalised(rings_of(inputs[i].features), rule)), FillRule::even_odd);
  }
  return result;
}

int run(const PolygonOptions& o, BooleanOp op, const std::string& title) {
  const FractionSink progress = start_work(o.work);
  const std::vector<PolygonInput> inputs = read_inputs(o, {.validity = true});
  if (progress) progress(0.2);
  const FillRule rule = fill_rule(o);
  const Regions regions = combined(op, inputs, rule, part_of(progress, 0.2, 0.9));
  Feature feature;
  feature.polygons = polygons_of(regions);

  Picture picture{.title = title};
  for (std::size_t i = 0; i < regions.size(); ++i)
    picture.areas.push_back({.rings = rings_of(regions[i]), .fill = pastel(i + 2), .edge = ink, .edge_width = 1.8});
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (const Ring& ring : rings_of(inputs[i].features))
      picture.lines.push_back({.points = ring, .colour = strong(i), .closed = true, .dashed = true, .width = 1.2});
    picture.legend.push_back({inputs[i].name, strong(i)});
  }
  const Rings boundary = rings_of(regions);
  add_indices(picture, boundary, ink);
  picture.legend.push_back(
      {title + ": " + counted(regions.size(), "region") + ", " + counted(boundary.size() - regions.size(), "hole"),
       pastel(2)});
  Features result;
  result.srid = inputs.front().features.srid;
  result.features.push_back(std::move(feature));
  write_geometry(o, inputs.front().format, result, picture);
  if (progress) progress(1);
  return done;
}

std::function<int()> add_boolean(CLI::App& app, PolygonOptions& options, BooleanOp op, const std::string& title,
                                 int least, const std::string& footer) {
  add_input_options(app, options)->expected(least, 1 << 20);
  add_geometry_outputs(app, options);
  add_work_options(app, options.work);
  app.footer(footer +
             "\nEach file's rings enclose by --rule. The result is always valid: simple rings that do not cross,\n"
             "outer ones counter-clockwise, holes clockwise.");
  return [&options, op, title] { return run(options, op, title); };
}

}  // namespace

std::function<int()> add_union(CLI::App& app) {
  static PolygonOptions options;
  return add_boolean(app, options, BooleanOp::unite, "union", 0,
                     "What lies in any of the files; one file alone is made valid.\n"
                     "Example: lambert polygon union a.geojson b.geojson -o ab.geojson --svg ab.svg");
}
std::function<int()> add_intersect(CLI::App& app) {
  static PolygonOptions options;
  return add_boolean(app, options, BooleanOp::intersect, "intersect", 2, "What lies in all of the files.");
}
std::function<int()> add_difference(CLI::App& app) {
  static PolygonOptions options;
  return add_boolean(app, options, BooleanOp::subtract, "difference", 2,
                     "What lies in the first file and in no other.");
}
std::function<int()> add_xor(CLI::App& app) {
  static PolygonOptions options;
  return add_boolean(app, options, BooleanOp::exclude, "xor", 2, "What lies in an odd number of the files.");
}

}  // namespace lambert::cli
