#include "places.h"

#include "../command.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/polygon/boolean/boolean.h"
#include "lambert/polygon/box.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

/// Throws Error where a double cannot hold an area: it would come out as infinite, or as nothing.
void check_range(const PathPlace& place, const Regions& regions, double enclosed, double around) {
  if (regions.empty()) return;
  const char* const size = !std::isfinite(enclosed) || !std::isfinite(around) ? "above 1.8e308"
                           : !(enclosed > 0)                                  ? "below 4.9e-324"
                                                                              : nullptr;
  if (size)
    throw Error(place.text() + ": the area is " + size + ", beyond the range of numbers; use another unit of length");
}

int run(const PolygonOptions& o) {
  const std::vector<PolygonInput> inputs = read_inputs(o, {.validity = true});
  const FillRule rule = fill_rule(o);
  nlohmann::ordered_json features = nlohmann::json::array();
  std::string text;
  Picture picture{.title = "area"};
  show_inputs(picture, inputs, rule);
  double total = 0;
  for (const PolygonInput& input : inputs)
    for (std::size_t i = 0; i < input.features.features.size(); ++i) {
      const Feature& feature = input.features.features[i];
      const Rings rings = rings_of(feature);
      const Regions regions = normalised(rings, rule);
      const Rings boundary = rings_of(regions);
      const Box2 box = box_of(rings);
      const double enclosed = area(regions);
      const PathPlace place{&input, i, {}, {}, {}};
      check_range(place, regions, enclosed, perimeter(boundary));
      total += enclosed;
      nlohmann::ordered_json j = place.json();
      j["area"] = enclosed;
      j["perimeter"] = perimeter(boundary);
      j["regions"] = regions.size();
      j["holes"] = boundary.size() - regions.size();
      j["signed_areas"] = nlohmann::json::array();
      for (const Ring& ring : rings) j["signed_areas"].push_back(signed_area(ring));
      if (!box.empty()) j["box"] = {{"min", {box.min.x, box.min.y}}, {"max", {box.max.x, box.max.y}}};
      features.push_back(j);
      text += place.text() + ": area " + number_text(enclosed) + ", perimeter " + number_text(perimeter(boundary)) +
              ", " + counted(regions.size(), "region") + ", " + counted(boundary.size() - regions.size(), "hole") +
              "\n";
    }
  if (!std::isfinite(total)) throw Error("area: the sum of all areas is above 1.8e308, beyond the range of numbers");
  if (features.size() > 1) text += "all: area " + number_text(total) + "\n";
  write_facts(o, {{"area", total}, {"features", features}}, text, picture);
  return done;
}

}  // namespace

std::function<int()> add_area(CLI::App& app) {
  static PolygonOptions options;
  add_input_options(app, options);
  add_fact_outputs(app, options);
  app.footer("The area that each feature's rings enclose by --rule; what they cover twice counts once.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
