#include "places.h"

#include "../command.h"
#include "../print_path.h"

#include "lambert/base/error.h"
#include "lambert/base/standard_streams.h"
#include "lambert/image/colour.h"
#include "lambert/image/io.h"
#include "lambert/polygon/box.h"
#include "lambert/polygon/predicates/scale.h"
#include "lambert/polygon/scan/scan_fill.h"
#include "lambert/polygon/scan/scan_table.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <map>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

struct Options : PolygonOptions {
  std::string resolution;
};

/// Runs of pixels, ends included, by row from the top.
using Table = std::map<int, std::vector<std::pair<int, int>>, std::greater<>>;

void print_table(const PolygonOptions& o, const Table& table, const Picture& picture) {
  nlohmann::ordered_json rows = nlohmann::json::array();
  std::string text;
  std::size_t pixels = 0;
  for (const auto& [y, spans] : table) {
    nlohmann::ordered_json row{{"y", y}, {"spans", nlohmann::json::array()}};
    text += std::to_string(y) + ":";
    for (const auto& [first, last] : spans) {
      row["spans"].push_back({first, last});
      text += " " + std::to_string(first) + ".." + std::to_string(last);
      pixels += static_cast<std::size_t>(last - first + 1);
    }
    rows.push_back(row);
    text += "\n";
  }
  write_facts(o, {{"pixels", pixels}, {"rows", rows}}, text + counted(pixels, "pixel") + "\n", picture);
}

void check_reach(const std::vector<PolygonInput>& inputs) {
  for_each_path(inputs, [](const PathPlace& place, const Path& path) {
    if (!place.ring) return;
    for (std::size_t i = 0; i < path.points.size(); ++i)
      if (const Vec2d p = path.points[i]; std::abs(p.x) > scan_table_reach || std::abs(p.y) > scan_table_reach)
        throw Error(place.text() + ", vertex " + std::to_string(i) + ": " + point_text(p) + " is beyond ±" +
                    std::to_string(scan_table_reach) + " pixels; --resolution fits polygons of any size");
  });
}

/// The textbook's table in the coordinates of the data.
int run_table(const Options& o) {
  const std::vector<PolygonInput> inputs = read_inputs(o, {});
  check_reach(inputs);
  const Rings rings = rings_of(joined(inputs));
  Table table;
  Picture picture{.title = "fill"};
  for (const PixelSpan& span : scan_table(rings, fill_rule(o))) {
    table[span.y].emplace_back(span.first, span.last);
    const double y = span.y;
    for (int x = span.first; x <= span.last && picture.areas.size() < 20'000; ++x)
      picture.areas.push_back(
          {.rings = {{{x - 0.5, y - 0.5}, {x + 0.5, y - 0.5}, {x + 0.5, y + 0.5}, {x - 0.5, y + 0.5}}},
           .fill = pastel(0),
           .edge = {255, 255, 255},
           .edge_width = 1});
  }
  for (const Ring& ring : rings) picture.lines.push_back({.points = ring, .colour = ink, .closed = true});
  add_indices(picture, rings, ink);
  print_table(o, table, picture);
  return done;
}

/// The features fitted to the pixels: both axes to one scale, in the middle, y up.
std::vector<Rings> fitted(const Features& features, Vec2i size) {
  const double unit = unit_scale(0.5 * sizes_of(rings_of(features)).most);
  const Box2 box = box_of(scaled(rings_of(features), unit));
  const Vec2d extent = box.size(), half(0.5 * size.x, 0.5 * size.y);
  const double scale = std::min(extent.x > 0 ? size.x / extent.x : 1e300, extent.y > 0 ? size.y / extent.y : 1e300);
  std::vector<Rings> all;
  for (const Feature& feature : features.features) {
    all.push_back(rings_of(feature));
    for (Ring& ring : all.back())
      for (Vec2d& p : ring) p = (unit * p - box.centre()) * std::min(scale, 1e300) + half;
  }
  return all;
}

void check_finite(const std::vector<Rings>& features) {
  for (const Rings& rings : features)
    for (const Ring& ring : rings)
      for (const Vec2d p : ring)
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
          throw Error("fill: the coordinates are too far apart to be fitted");
}

int run_pixels(Options o) {
  const Vec2i size = parse_size("--resolution", o.resolution);
  const std::vector<PolygonInput> inputs = read_inputs(o, {});
  const FillRule rule = fill_rule(o);
  const std::vector<Rings> features = fitted(joined(inputs), size);
  check_finite(features);
  const auto is_png = [](const std::string& path) { return format_extension(path) == ".png"; };
  const auto pngs = std::stable_partition(o.outputs.begin(), o.outputs.end(), std::not_fn(is_png));
  const std::vector<std::string> images(pngs, o.outputs.end());
  o.outputs.erase(pngs, o.outputs.end());

  Table table;
  Image image(size.x, size.y, rgb_channels());
  std::ranges::fill(image.pixels(), 1.0f);
  Picture picture{.title = "fill " + o.resolution};
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Colour c = features.size() == 1 ? Colour{} : strong(i);
    const auto channel = [](std::uint8_t v) { return srgb_decode(static_cast<float>(v) / 255.0f); };
    const Rgb colour(channel(c.red), channel(c.green), channel(c.blue));
    picture.areas.push_back({.rings = features[i], .rule = rule, .fill = pastel(i), .edge = ink});
    for_each_span(features[i], rule, {0, size.x, 0, size.y}, [&](int y, int begin, int end) {
      table[y].emplace_back(begin, end - 1);
      for (int x = begin; x < end; ++x) image.set_rgb(x, size.y - 1 - y, colour);
    });
  }
  for (const std::string& path : images) write_image(path, image);
  for (auto& [y, spans] : table) std::ranges::sort(spans);
  if (images.empty() || o.json || !o.outputs.empty() || !o.svg.empty() || !o.png.empty())
    print_table(o, table, picture);
  if (!o.json)
    for (const std::string& path : images) print_path(path);
  return done;
}

}  // namespace

std::function<int()> add_fill(CLI::App& app) {
  static Options options;
  add_input_options(app, options);
  app.add_option("--resolution", options.resolution,
                 "Fit the features to WIDTHxHEIGHT pixels; -o FILE.png writes them");
  add_fact_outputs(app, options);
  app.footer(
      "Without --resolution: the scan-line table of vertices rounded to whole pixels, ends of spans included.\n"
      "With it: the pixels whose centres lie inside, each in one polygon of a tiling. Rows count upwards.");
  return [] { return options.resolution.empty() ? run_table(options) : run_pixels(options); };
}

}  // namespace lambert::cli
