#include "command.h"
#include "exposure_flag.h"
#include "number_range.h"
#include "print_path.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/number.h"
#include "lambert/draw/montage.h"
#include "lambert/image/filter/resize.h"
#include "lambert/image/io.h"
#include "lambert/image/tonemap/tonemap.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace lambert::cli {
namespace {

struct TonemapOptions {
  std::vector<std::string> inputs, outputs, operators, assignments;
  std::string exposure = "0", channels, percentiles;
  float key = AutoExposure{}.key;
  float saturation = 1;
  bool montage = false, list = false, json = false;
  int columns = 0, tile_width = 400;
};

std::pair<float, float> percentiles(const std::string& text) {
  const auto read = [&](std::string_view word) {
    float value = -1;
    const bool whole = parse_float(word.data(), word.data() + word.size(), value) == word.data() + word.size();
    return whole ? value : -1.0f;
  };
  const auto comma = text.find(',');
  const float low = read(std::string_view(text).substr(0, comma));
  const float high = comma == std::string::npos ? -1.0f : read(std::string_view(text).substr(comma + 1));
  if (!(low >= 0 && low < high && high <= 100))
    throw Error("--percentiles: expected LOW,HIGH with 0 <= LOW < HIGH <= 100, got '" + printable(text) + "'");
  return {low, high};
}

ToneSettings common_settings(const TonemapOptions& o) {
  AutoExposure automatic{.key = o.key};
  if (!o.percentiles.empty()) std::tie(automatic.low, automatic.high) = percentiles(o.percentiles);
  ToneSettings settings{.saturation = o.saturation};
  set_exposure(settings, o.exposure, automatic);
  if (!o.channels.empty()) settings.channels = tone_channels(o.channels);
  return settings;
}

ToneOperator configured_operator(const std::string& name, const std::vector<std::string>& assignments) {
  ToneOperator op = tone_operator(name);
  SettingTable table = tone_operator_settings(op);
  for (const std::string& assignment : assignments) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos) throw Error("--set: expected key=value, got '" + printable(assignment) + "'");
    table.set(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  return op;
}

/// The mean of the pixels that each pixel of a picture `width` wide covers; as it is when it is not wider.
Image shrunk(const Image& image, int width) {
  if (image.width() <= width) return image;
  const double height = static_cast<double>(image.height()) * width / image.width();
  return resized(image, width, std::max(1, static_cast<int>(std::lround(height))),
                 {.filter = {.kind = FilterKind::box}});
}

Image montage_of(const std::vector<Image>& inputs, const std::vector<std::string>& names, const TonemapOptions& o) {
  ToneSettings settings = common_settings(o);
  std::vector<draw::Panel> panels;
  for (const std::string& name : names) {
    if (o.operators.empty() && name == tone::Ocio::name && !tone::Ocio::available()) continue;
    settings.op = configured_operator(name, {});
    panels.push_back({name, shrunk(tonemap(inputs.front(), settings), o.tile_width)});
  }
  return draw::montage(panels, {.columns = o.columns});
}

/// One image by one operator; several are a stack of exposures.
Image mapped(std::vector<Image> inputs, const std::string& name, const TonemapOptions& o) {
  ToneSettings settings = common_settings(o);
  settings.op = configured_operator(name, o.assignments);
  if (inputs.size() == 1) return tonemap(std::move(inputs.front()), settings);
  return tone::fuse_exposures(inputs, std::get<tone::Mertens>(settings.op));
}

void check(const TonemapOptions& o) {
  for (const std::string& name : o.operators) tone_operator(name);
  if (o.inputs.empty()) throw Error("no image was given");
  if (o.outputs.empty()) throw Error("no output was given: name it with -o");
  if (o.operators.size() > 1 && !o.montage) throw Error("--operator: several need --montage");
  if (o.montage && !o.assignments.empty()) throw Error("--set belongs to one operator, not to --montage");
  if (o.inputs.size() > 1 && (o.montage || o.operators != std::vector<std::string>{tone::Mertens::name}))
    throw Error("several images are a stack of exposures, for which there is --operator mertens");
  for (const std::string& path : o.outputs) {
    is_radiance_format(path);
    check_writable(path);
  }
}

void print_operators(bool json) {
  nlohmann::ordered_json all = nlohmann::json::array();
  for (const std::string& name : tone_operator_names()) {
    ToneOperator op = tone_operator(name);
    const SettingTable table = tone_operator_settings(op);
    nlohmann::ordered_json settings = nlohmann::json::array();
    if (!json) fmt::print("{}\n  {}\n", name, tone_operator_summary(op));
    for (const Setting& s : table.settings()) {
      if (!json) fmt::print("  --set {}={:<10} {}\n", s.key, to_string(s), s.help);
      settings.push_back({{"key", s.key}, {"default", to_string(s)}, {"help", s.help}});
    }
    all.push_back({{"name", name}, {"summary", tone_operator_summary(op)}, {"settings", settings}});
  }
  if (json) fmt::print("{}\n", all.dump(2));
}

int run(const TonemapOptions& o) {
  if (o.list) {
    print_operators(o.json);
    return done;
  }
  check(o);
  std::vector<Image> inputs;
  for (const std::string& path : o.inputs) inputs.push_back(read_image(path));
  const Image shown =
      o.montage ? montage_of(inputs, o.operators.empty() ? tone_operator_names() : o.operators, o)
                : mapped(std::move(inputs), o.operators.empty() ? tone::Photographic::name : o.operators.front(), o);
  for (const std::string& path : o.outputs) {
    write_image(path, shown);
    print_path(path);
  }
  return done;
}

}  // namespace

std::function<int()> add_tonemap(CLI::App& app) {
  static TonemapOptions o;
  const std::string names = fmt::format("{}", fmt::join(tone_operator_names(), ", "));
  app.add_option("input", o.inputs, "Radiance map; several images are a stack of exposures (mertens)")
      ->type_name("FILE");
  app.add_option("-o,--output", o.outputs, "Image to write, several allowed")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--operator", o.operators, "photographic by default; with --montage several: " + names)
      ->type_name("NAME")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--set", o.assignments, "A setting of the operator, key=value; several allowed (see --list)")
      ->allow_extra_args(false);
  app.add_option("--exposure", o.exposure, "Stops before the operator, auto, or auto with stops: auto+1")
      ->capture_default_str();
  expect_number(app.add_option("--key", o.key, "Where --exposure auto puts the log-average")->capture_default_str(),
                {.expected = "a number from 1e-6 to 1e6", .low = 1e-6, .below = 1.000001e6});
  app.add_option("--percentiles", o.percentiles, "Luminances that --exposure auto looks at; by default 1,99")
      ->type_name("LOW,HIGH");
  app.add_option("--channels", o.channels,
                 "Apply to luminance, keeping ratios of colours, or to each channel (rgb); by default as published")
      ->type_name("luminance|rgb");
  expect_number(app.add_option("--saturation", o.saturation, "Exponent of the colours' ratios to luminance"),
                {.expected = "a number from 0 to 4", .low = 0, .below = 4.000001});
  app.add_flag("--montage", o.montage, "All operators side by side with their names");
  expect_number(app.add_option("--columns", o.columns, "Of the montage; 0: as square as may be")->capture_default_str(),
                {.expected = "a whole number from 0 to 100", .low = 0, .below = 101});
  expect_number(app.add_option("--tile-width", o.tile_width, "Of the montage, at most, pixels")->capture_default_str(),
                {.expected = "a whole number from 16 to 4096", .low = 16, .below = 4097});
  app.add_flag("--list", o.list, "List the operators and their settings");
  app.add_flag("--json", o.json, "The list as JSON");
  app.footer(
      "Try:\n"
      "  lambert tonemap room.exr -o room.png\n"
      "  lambert tonemap room.exr --operator durand --set contrast=8 --exposure auto -o room.png\n"
      "  lambert tonemap room.exr --montage --exposure auto -o all.png\n"
      "  lambert tonemap short.jpg middle.jpg long.jpg --operator mertens -o fused.png");
  return [] { return run(o); };
}

}  // namespace lambert::cli
