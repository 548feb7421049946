#include "places.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/number.h"
#include "lambert/polygon/scale.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

std::string standard_input() {
  constexpr std::size_t most = std::size_t{1} << 32;
  std::string text;
  std::array<char, 65536> block;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), stdin)) {
    text.append(block.data(), count);
    if (text.size() > most) throw Error("standard input: more than 4 GB");
  }
  return text;
}

PolygonInput read_input(const std::string& file) {
  if (file == "-") {
    const std::string text = standard_input(), name = "standard input";
    const FileFormat format = format_of_content(text);
    return {name, parse_features(text, name, format), format};
  }
  const auto named = format_of(file);
  return {file, read_features(file), named ? *named : format_of_content(MappedFile(file).text())};
}

}  // namespace

CLI::Option* add_input_options(CLI::App& app, PolygonOptions& o, bool with_rule) {
  if (with_rule) app.add_option("--rule", o.rule, "What rings enclose: even-odd or non-zero")->capture_default_str();
  return app.add_option("files", o.files, "GeoJSON, WKT or vertex lists; none or -: standard input")->type_name("FILE");
}

std::vector<PolygonInput> read_inputs(const PolygonOptions& o) {
  std::vector<PolygonInput> inputs;
  if (o.files.empty()) inputs.push_back(read_input("-"));
  for (const std::string& file : o.files) inputs.push_back(read_input(file));
  return inputs;
}

void note_what_counts_not(const std::vector<PolygonInput>& inputs) {
  for (const PolygonInput& input : inputs) {
    std::size_t lines = 0, points = 0;
    Sizes sizes;
    for (const Feature& feature : input.features.features) {
      lines += feature.lines.size(), points += feature.points.points.size();
      sizes.add(rings_of(feature));
    }
    std::string words = lines > 0 ? counted(lines, "line") : "";
    if (points > 0) words += (lines > 0 ? " and " : "") + counted(points, "point");
    if (!words.empty()) fmt::print(stderr, "lambert: note: {}: {} left out: they enclose nothing\n", input.name, words);
    // The grid of boolean.h.
    if (sizes.most > 0 && std::ilogb(sizes.least) < std::ilogb(sizes.most) - 420)
      fmt::print(stderr, "lambert: note: {}: beside coordinates of {} those of {} are rounded to a multiple of {}\n",
                 input.name, number_text(sizes.most), number_text(sizes.least),
                 number_text(std::ldexp(1.0, std::ilogb(sizes.most) - 471)));
  }
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

Feature cut_from(const Feature& source) {
  Feature feature;
  feature.name = source.name;
  for (const JsonMember& member : source.members)
    if (member.key != "bbox") feature.members.push_back(member);
  return feature;
}

std::vector<double> parse_reals(const std::string& flag, const std::string& text, std::size_t count,
                                const std::string& expected) {
  const auto fail = [&] { throw Error(flag + ": expected " + expected + ", got '" + printable(text) + "'"); };
  std::vector<double> numbers;
  const char *at = text.data(), *const end = at + text.size();
  while (numbers.size() < count) {
    double value = 0;
    at = parse_double(at, end, value);
    if (!at) fail();
    numbers.push_back(value);
    if (numbers.size() == count) break;
    if (at == end || *at != ',') fail();
    ++at;
  }
  if (at != end) fail();
  return numbers;
}

Vec2i parse_size(const std::string& flag, const std::string& text) {
  std::int64_t width = 0, height = 0;
  const char* const end = text.data() + text.size();
  const char* at = parse_int(text.data(), end, width);
  if (at && at != end && *at == 'x') at = parse_int(at + 1, end, height);
  constexpr std::int64_t most = 16384;
  if (at != end || width < 1 || height < 1 || width > most || height > most)
    throw Error(flag + ": expected WIDTHxHEIGHT from 1 to 16384, got '" + printable(text) + "'");
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::string point_text(Vec2d p) { return "(" + number_text(p.x) + ", " + number_text(p.y) + ")"; }

}  // namespace lambert::cli
