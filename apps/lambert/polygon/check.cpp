#include "places.h"

#include "../command.h"

#include "lambert/polygon/queries/check.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

const char* word_for(ChainCheck::Fault fault) {
  switch (fault) {
    case ChainCheck::Fault::none: return "none";
    case ChainCheck::Fault::too_few: return "too-few";
    case ChainCheck::Fault::not_closed: return "not-closed";
    case ChainCheck::Fault::repeated_vertex: break;
  }
  return "repeated-vertex";
}

struct Checked {
  ChainCheck check;
  std::size_t size;
};
/// Lines, and rings that do not end where they began, are lists that should be closed; of rings the readers have
/// dropped the repetition.
Checked check_path(const PathPlace& place, const Path& path) {
  const bool is_list = place.line || !path.closed;
  const std::size_t size = path.points.size();
  if (path.heights.empty()) return {is_list ? check_closed_list(path.points) : check_ring(path.points), size};
  const std::vector<Vec3d> vertices = in_space(path);
  return {is_list ? check_closed_list(vertices) : check_ring(vertices), size};
}

int run(const PolygonOptions& o) {
  const std::vector<PolygonInput> inputs = read_inputs(o, {.lines = true, .ring_heights = true, .line_heights = true});
  nlohmann::ordered_json paths = nlohmann::json::array();
  std::string text;
  Picture picture{.title = "check"};
  show_inputs(picture, inputs);
  std::size_t faults = 0;
  for_each_path(inputs, [&](const PathPlace& place, const Path& path) {
    const auto [check, size] = check_path(place, path);
    nlohmann::ordered_json j = place.json();
    j["vertices"] = size;
    j["fault"] = word_for(check.fault);
    if (!check) {
      ++faults;
      if (check.fault != ChainCheck::Fault::too_few) {
        j["index"] = check.index;
        picture.points.push_back(
            {.at = path.points[check.index], .colour = alarm, .shape = Picture::Shape::circle, .radius = 8});
      }
      j["message"] = message_of(check, size);
      text += place.text() + ": " + message_of(check, size) + "\n";
    }
    paths.push_back(j);
  });
  if (faults == 0) text = counted(paths.size(), "path") + ": closed, without repeated vertices\n";
  write_facts(o, {{"ok", faults == 0}, {"paths", paths}}, text, picture);
  return faults == 0 ? done : failed;
}

}  // namespace

std::function<int()> add_check(CLI::App& app) {
  static PolygonOptions options;
  add_input_options(app, options, false);
  add_fact_outputs(app, options);
  app.footer("Exit status 1 when a ring or line is not closed, has too few vertices or repeats one in succession.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
