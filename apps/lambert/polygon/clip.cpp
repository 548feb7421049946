#include "places.h"

#include "../command.h"

#include "lambert/base/error.h"
#include "lambert/polygon/boolean/boolean.h"
#include "lambert/polygon/box.h"
#include "lambert/polygon/clip/components.h"
#include "lambert/polygon/clip/half_plane_clip.h"
#include "lambert/polygon/clip/window_clip.h"
#include "lambert/polygon/predicates/scale.h"
#include "lambert/polygon/queries/line_through.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <optional>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

struct Options : PolygonOptions {
  std::string window, line;
  std::vector<std::string> half_planes;
  bool trace = false;
};

ClipLine parse_line(const std::string& flag, const std::string& text) {
  const std::vector<double> n = parse_reals(flag, text, 4, "ax,ay,bx,by");
  const ClipLine line{{n[0], n[1]}, {n[2], n[3]}};
  if (line.tail == line.head) throw Error(flag + ": expected two different points, got '" + text + "'");
  return line;
}

struct Clips {
  std::optional<Box2> window;
  std::vector<ClipLine> half_planes;
};

Clips parse_clips(const Options& o) {
  Clips clips;
  if (!o.window.empty()) clips.window = parse_window("--window", o.window);
  for (const std::string& text : o.half_planes) clips.half_planes.push_back(parse_line("--half-plane", text));
  return clips;
}

/// The part of a line that the picture shows: across the box of the data, and a little beyond.
Ring shown_part(const ClipLine& line, const Box2& box) {
  if (box.empty()) return {};
  Sizes sizes;
  for (const Vec2d p : {line.head, line.tail, box.min, box.max}) sizes.add(p);
  const double unit = unit_scale(sizes.most);
  const Vec2d low = unit * box.min, high = unit * box.max, tail = unit * line.tail, along = unit * line.head - tail;
  const Vec2d direction = along / safe_length(along), centre = 0.5 * (low + high);
  const Vec2d foot = tail + direction * glm::dot(centre - tail, direction);
  const double reach = 0.55 * glm::length(high - low);
  return {(foot - direction * reach) / unit, (foot + direction * reach) / unit};
}

Regions clipped(const Feature& feature, const Clips& clips, FillRule rule) {
  Rings rings = rings_of(normalised(rings_of(feature), rule));
  if (clips.window) rings = clip_to_rectangle(rings, clips.window->min, clips.window->max);
  for (const ClipLine& line : clips.half_planes) rings = clip_to_half_plane(rings, line);
  return components(rings);
}

int run_regions(const Options& o) {
  const Clips clips = parse_clips(o);
  const std::vector<PolygonInput> inputs = read_inputs(o, {.validity = true});
  const FillRule rule = fill_rule(o);
  const Features all = joined(inputs);
  const Box2 box = box_of(rings_of(all));
  Picture picture{.title = "clip"};
  const Features result = cut_from(all, [&](const Feature& source, Feature& feature) {
    for (const Ring& ring : rings_of(source))
      picture.lines.push_back({.points = ring, .colour = slate, .closed = true, .dashed = true, .width = 1.2});
    const Regions regions = clipped(source, clips, rule);
    for (const Region& region : regions) {
      picture.areas.push_back(
          {.rings = rings_of(region), .fill = pastel(picture.areas.size()), .edge = ink, .edge_width = 1.8});
      add_indices(picture, rings_of(region), ink);
    }
    feature.polygons = polygons_of(regions);
  });
  if (clips.window) {
    const Vec2d a = clips.window->min, b = clips.window->max;
    picture.lines.push_back({.points = {a, {b.x, a.y}, b, {a.x, b.y}}, .colour = alarm, .closed = true});
  }
  for (const ClipLine& line : clips.half_planes)
    picture.lines.push_back({.points = shown_part(line, box), .colour = alarm, .arrows = true});
  write_geometry(o, inputs.front().format, result, picture);
  return done;
}

int run_line(const Options& o) {
  const ClipLine line = parse_line("--line", o.line);
  const std::vector<PolygonInput> inputs = read_inputs(o, {});
  const FillRule rule = fill_rule(o);
  const Features all = joined(inputs);
  Picture picture{.title = "clip a line"};
  show_inputs(picture, inputs, rule);
  picture.lines.push_back({.points = shown_part(line, box_of(rings_of(all))),
                           .colour = slate,
                           .arrows = true,
                           .dashed = true,
                           .width = 1.2});
  const Features result = cut_from(all, [&](const Feature& source, Feature& feature) {
    for (const LinePiece& piece : line_through(rings_of(source), line.tail, line.head, rule).inside) {
      feature.lines.push_back({.points = {piece.from, piece.to}, .heights = {}});
      picture.lines.push_back({.points = {piece.from, piece.to}, .colour = alarm, .width = 3});
    }
  });
  write_geometry(o, inputs.front().format, result, picture);
  return done;
}

/// The state machine's table for each ring: vertices are numbered from 1, crossings are letters.
int run_trace(const Options& o) {
  if (o.half_planes.size() != 1 || !o.window.empty()) throw Error("--trace: expected one --half-plane and no --window");
  if (!o.outputs.empty() || !o.svg.empty() || !o.png.empty() || !o.format.empty())
    throw Error("--trace: it prints a table, neither geometry nor a picture");
  const ClipLine line = parse_line("--half-plane", o.half_planes.front());
  for_each_path(read_inputs(o, {}), [&](const PathPlace& place, const Path& path) {
    if (!place.ring) return;
    std::vector<LabelledVertex> vertices;
    for (const Vec2d p : path.points) vertices.push_back({.position = p, .label = std::to_string(vertices.size() + 1)});
    const ClipTrace trace = trace_clip(vertices, line);
    fmt::print("{}\n{:>6}  {:<9} {}\n", place.text(), "vertex", "state", "output");
    for (const ClipStep& step : trace.steps)
      fmt::print("{:>6}  {:<9} {}\n", step.input, name_of(step.state), fmt::join(step.output, " "));
    fmt::print("result:");
    for (const LabelledVertex& v : trace.ring) fmt::print(" {}", v.label);
    fmt::print("\n");
  });
  return done;
}

int run(const Options& o) {
  if (!o.line.empty()) {
    if (!o.window.empty() || !o.half_planes.empty() || o.trace)
      throw Error("--line: it clips the line, so there is no window or half-plane");
    return run_line(o);
  }
  if (o.window.empty() && o.half_planes.empty()) throw Error("clip: expected --window, --half-plane or --line");
  return o.trace ? run_trace(o) : run_regions(o);
}

}  // namespace

std::function<int()> add_clip(CLI::App& app) {
  static Options options;
  add_input_options(app, options);
  app.add_option("--window", options.window, "Keep what is in the rectangle x0,y0,x1,y1");
  app.add_option("--half-plane", options.half_planes,
                 "Keep what is left of the line from a to b, ax,ay,bx,by; several allowed")
      ->allow_extra_args(false);
  app.add_option("--line", options.line, "The pieces of the line through a and b inside the polygons, ax,ay,bx,by");
  app.add_flag("--trace", options.trace, "Print the steps of Sutherland and Hodgman's machine for one half-plane");
  add_geometry_outputs(app, options);
  app.footer(
      "What falls apart becomes several polygons; features keep their properties.\n"
      "Example: lambert polygon clip land.geojson --window=-10,35,30,60 -o europe.geojson");
  return [] { return run(options); };
}

}  // namespace lambert::cli
