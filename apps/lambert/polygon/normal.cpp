#include "places.h"

#include "../command.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/polygon/queries/normal.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

std::string text_of(Vec3d v) {
  return "(" + number_text(v.x + 0.0) + ", " + number_text(v.y + 0.0) + ", " + number_text(v.z + 0.0) + ")";
}

int run(const PolygonOptions& o) {
  const std::vector<PolygonInput> inputs = read_inputs(o, {.ring_heights = true});
  nlohmann::ordered_json rings = nlohmann::json::array();
  std::string text;
  Picture picture{.title = "normal (seen along z)"};
  show_inputs(picture, inputs);
  bool all_have_one = true;
  for_each_path(inputs, [&](const PathPlace& place, const Path& path) {
    if (!place.ring) return;
    const std::vector<Vec3d> vertices = in_space(path);
    nlohmann::ordered_json j = place.json();
    const auto normal = newell_normal(vertices);
    all_have_one = all_have_one && normal;
    if (normal) {
      const double sine = out_of_plane_sine(vertices), area = face_area(vertices);
      if (!std::isfinite(area) || area == 0)
        throw Error(place.text() + ": the area is " + (area == 0 ? "below 4.9e-324" : "above 1.8e308") +
                    ", beyond the range of numbers; use another unit of length");
      const bool planar = is_planar(vertices);
      j["normal"] = {normal->x + 0.0, normal->y + 0.0, normal->z + 0.0};
      j["area"] = area;
      j["planar"] = planar;
      j["out_of_plane_sine"] = sine;
      j["dropped_axis"] = std::string(1, "xyz"[dominant_axis(*normal)]);
      text +=
          place.text() + ": normal " + text_of(*normal) + ", area " + number_text(area) +
          (planar ? ", planar" : ", not planar: an edge leaves the plane by an angle of sine " + number_text(sine)) +
          "\n";
    } else {
      j["normal"] = nullptr;
      const char* const reason = on_one_line(vertices) ? "all vertices lie on a line" : "its signed areas cancel";
      j["reason"] = reason;
      text += place.text() + ": no normal: " + reason + "\n";
    }
    rings.push_back(j);
  });
  write_facts(o, {{"rings", rings}}, text, picture);
  return all_have_one ? done : failed;
}

}  // namespace

std::function<int()> add_normal(CLI::App& app) {
  static PolygonOptions options;
  add_input_options(app, options, false);
  add_fact_outputs(app, options);
  app.footer("By Newell's sum; vertices may have a third coordinate. Exit status 1 when a ring has no normal.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
