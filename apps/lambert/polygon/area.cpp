#include "places.h"

#include "../command.h"

#include "lambert/base/number.h"
#include "lambert/polygon/boolean.h"
#include "lambert/polygon/box.h"

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

double perimeter(const Rings& rings) {
  double sum = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) sum += glm::length(ring[next_index(i, ring.size())] - ring[i]);
  return sum;
}

int run(const PolygonOptions& o) {
  const std::vector<PolygonInput> inputs = read_inputs(o);
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
      total += enclosed;
      const PathPlace place{&input, i, {}, {}, {}};
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
