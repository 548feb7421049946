#include "filter_options.h"
#include "../outputs.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace lambert::cli {

void add_image_paths(CLI::App& app, FilterOptions& o) {
  app.add_option("input", o.input, "The image")->required()->type_name("IN");
  add_outputs(app, o.outputs, "Image to write, by extension")->required();
  add_work_options(app, o.work);
}

void add_edge_option(CLI::App& app, FilterOptions& o) {
  app.add_option("--edge", o.edge, "What stands around the image: " + listed(edge_mode_names()))->capture_default_str();
}

Image read_input(const FilterOptions& o, const FractionSink& progress) {
  check_images(o.outputs);
  Image image = read_image(o.input);
  if (progress) progress(0.3);
  return image;
}

void write_outputs(const FilterOptions& o, Image image, const FractionSink& progress) {
  image.metadata["software"] = "lambert " LAMBERT_VERSION;
  write_images(o.outputs, image, {}, part_of(progress, 0.7, 1));
}

Vec2 parse_per_axis(const std::string& flag, const std::string& text, float low, float high) {
  const char *p = text.data(), *end = p + text.size();
  Vec2 v(0);
  p = parse_float(p, end, v.x);
  v.y = v.x;
  if (p && p != end) p = *p == 'x' ? parse_float(p + 1, end, v.y) : nullptr;
  if (p != end || !(v.x >= low && v.x <= high && v.y >= low && v.y <= high))
    throw Error(
        fmt::format("{}: expected numbers from {} to {} such as 5 or 5x3, got '{}'", flag, low, high, printable(text)));
  return v;
}

std::string listed(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

}  // namespace lambert::cli
