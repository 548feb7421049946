#include "verb.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/log.h"
#include "lambert/base/number.h"
#include "lambert/base/standard_streams.h"
#include "lambert/polygon/predicates/scale.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <limits>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

PolygonInput read_input(const std::string& file) {
  if (file == "-") {
    const MappedFile input = open_input(file);
    const FileFormat format = format_of_content(input.text());
    return {input_name(file), parse_features(input.text(), input_name(file), format), format};
  }
  const auto named = format_of(file);
  return {file, read_features(file), named ? *named : format_of_content(MappedFile(file).text())};
}

void note_left_out(const PolygonInput& input, Uses uses) {
  std::size_t lines = 0, points = 0;
  bool heights = false;
  for (const Feature& feature : input.features.features) {
    points += feature.points.points.size(), lines += feature.lines.size();
    if (uses.lines && !uses.line_heights)
      for (const Path& line : feature.lines) heights = heights || !line.heights.empty();
    if (!uses.ring_heights)
      for (const PathPolygon& polygon : feature.polygons)
        for (const Path& ring : polygon) heights = heights || !ring.heights.empty();
  }
  std::vector<std::string> parts;
  if (lines > 0 && !uses.lines) parts.push_back(counted(lines, "line"));
  if (points > 0 && !uses.points) parts.push_back(counted(points, "point"));
  if (heights) parts.emplace_back("third coordinates");
  if (!parts.empty()) log::info(fmt::format("{}: left out: {}", input.name, fmt::join(parts, ", ")));
}

/// By the grid of boolean.h.
void note_rounding(const PolygonInput& input) {
  Sizes sizes;
  for (const Feature& feature : input.features.features) sizes.add(rings_of(feature));
  if (sizes.most > 0 && std::ilogb(sizes.least) < std::ilogb(sizes.most) - 420)
    log::info(fmt::format("{}: beside coordinates of {} those of {} are rounded to a multiple of {}", input.name,
                          number_text(sizes.most), number_text(sizes.least),
                          number_text(std::ldexp(1.0, std::ilogb(sizes.most) - 471))));
}

}  // namespace

CLI::Option* add_input_options(CLI::App& app, PolygonOptions& o, bool with_rule) {
  if (with_rule) app.add_option("--rule", o.rule, "What rings enclose: even-odd or non-zero")->capture_default_str();
  return app.add_option("files", o.files, "GeoJSON, WKT or vertex lists; none or -: standard input")->type_name("FILE");
}

std::vector<PolygonInput> read_inputs(const PolygonOptions& o, Uses uses) {
  std::vector<PolygonInput> inputs;
  if (o.files.empty()) inputs.push_back(read_input("-"));
  for (const std::string& file : o.files) inputs.push_back(read_input(file));
  for (const PolygonInput& input : inputs) {
    note_left_out(input, uses);
    if (uses.validity) note_rounding(input);
  }
  return inputs;
}

Features joined(const std::vector<PolygonInput>& inputs) {
  Features all = inputs.front().features;
  for (std::size_t i = 1; i < inputs.size(); ++i)
    for (const Feature& feature : inputs[i].features.features) all.features.push_back(feature);
  return all;
}

FillRule fill_rule(const PolygonOptions& o) {
  if (o.rule == "even-odd") return FillRule::even_odd;
  if (o.rule == "non-zero") return FillRule::non_zero;
  throw Error("--rule: unknown rule " + unknown_word(o.rule, {"even-odd", "non-zero"}));
}

Features cut_from(const Features& all, const std::function<void(const Feature&, Feature&)>& add) {
  Features result;
  result.members = all.members, result.srid = all.srid;
  for (const Feature& source : all.features) {
    result.features.push_back(cut_from(source));
    add(source, result.features.back());
  }
  return result;
}

Feature cut_from(const Feature& source) {
  Feature feature;
  feature.name = source.name;
  for (const JsonMember& member : source.members)
    if (member.key != "bbox") feature.members.push_back(member);
  return feature;
}

}  // namespace lambert::cli
