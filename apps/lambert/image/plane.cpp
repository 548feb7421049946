#include "filter_options.h"
#include "verb.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"

#include "lambert/image/filter/textured_plane.h"
#include "lambert/image/io.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace lambert::cli {
namespace {

struct Options : FilterOptions {
  std::vector<std::string> lookups;
  std::string size = "256x256";
  int samples = 1;
  float anisotropy = 16;
};

Image joined(const std::vector<Image>& panels, int gap) {
  const Image& first = panels[0];
  const int step = first.width() + gap;
  Image out(static_cast<int>(panels.size()) * step - gap, first.height(), rgb_channels());
  std::ranges::fill(out.pixels(), 1.0f);
  for (int y = 0; y < first.height(); ++y)
    for (std::size_t i = 0; i < panels.size(); ++i)
      std::ranges::copy(panels[i].row(y), out.row(y).begin() + 3 * static_cast<std::ptrdiff_t>(i) * step);
  return out;
}

int run(const Options& o) {
  check_images(o.outputs);
  TexturedPlane plane{.samples = o.samples};
  const Vec2 size = parse_per_axis("--size", o.size, 1, 8192);
  plane.width = static_cast<int>(size.x), plane.height = static_cast<int>(size.y);
  const EdgeMode edge = edge_mode(o.edge);
  plane.lookup.edges = {edge, edge};
  plane.lookup.max_anisotropy = o.anisotropy;
  const Pyramid texture(o.input.empty() ? checkerboard(256, 8) : read_image(o.input));
  const FractionSink progress = start_work(o.work);
  const std::vector<std::string> names = o.lookups.empty() ? lookup_method_names() : o.lookups;
  std::vector<Image> panels;
  for (const std::string& name : names) {
    plane.lookup.method = lookup_method(name);
    panels.push_back(textured_plane(texture, plane));
    if (progress) progress(0.7 * static_cast<double>(panels.size()) / static_cast<double>(names.size()));
  }
  write_outputs(o, joined(panels, 2), progress);
  return done;
}

}  // namespace

std::function<int()> add_plane(CLI::App& app) {
  static Options o;
  o.edge = "repeat";
  app.add_option("input", o.input, "The texture; a checkerboard when there is none")->type_name("IN");
  add_outputs(app, o.outputs, "Image to write, by extension")->required();
  add_work_options(app, o.work);
  app.add_option("--lookup", o.lookups, "Side by side, in this order: " + listed(lookup_method_names()) + " (all)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--size", o.size, "WxH of one picture")->capture_default_str();
  expect_number(app.add_option("--samples", o.samples, "Per pixel and axis")->capture_default_str(),
                whole_number(1, 64));
  expect_number(app.add_option("--anisotropy", o.anisotropy, "The longest ellipse by its ratio")->capture_default_str(),
                {.expected = "a ratio from 1 to 256", .low = 1, .below = 256.001});
  add_edge_option(app, o);
  return [] { return run(o); };
}

}  // namespace lambert::cli
