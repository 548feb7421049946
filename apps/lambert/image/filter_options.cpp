#include "filter_options.h"
#include "../print_path.h"

#include "lambert/base/error.h"
#include "lambert/base/number.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>

namespace lambert::cli {

void add_image_paths(CLI::App& app, FilterOptions& o) {
  app.add_option("input", o.input, "The image")->required()->type_name("IN");
  app.add_option("-o,--output", o.outputs, "Image files to write")
      ->required()
      ->type_name("OUT")
      ->allow_extra_args(false);
}

void add_edge_option(CLI::App& app, FilterOptions& o) {
  app.add_option("--edge", o.edge, "What stands around the image: " + listed(edge_mode_names()))->capture_default_str();
}

void write_and_print(const std::string& path, const Image& image) {
  write_image(path, image);
  print_path(path);
}

void write_outputs(const FilterOptions& o, Image image) {
  image.metadata["software"] = "lambert " LAMBERT_VERSION;
  for (const std::string& path : o.outputs) write_and_print(path, image);
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
