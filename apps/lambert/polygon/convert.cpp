#include "places.h"

#include "../command.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

std::function<int()> add_convert(CLI::App& app) {
  static PolygonOptions options;
  add_input_options(app, options);
  add_geometry_outputs(app, options);
  app.footer("All features as they are, in another format or as a picture.");
  return [] {
    const std::vector<PolygonInput> inputs =
        read_inputs(options, {.lines = true, .points = true, .ring_heights = true, .line_heights = true});
    Picture picture;
    show_inputs(picture, inputs, fill_rule(options));
    write_geometry(options, inputs.front().format, joined(inputs), picture);
    return done;
  };
}

}  // namespace lambert::cli
