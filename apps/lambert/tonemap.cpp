#include "tonemap/options.h"

#include "command.h"
#include "number_range.h"
#include "outputs.h"

#include "lambert/base/error.h"
#include "lambert/draw/montage.h"
#include "lambert/image/filter/resize.h"
#include "lambert/image/io.h"
#include "lambert/image/tonemap/tonemap.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lambert::cli {
namespace {

/// The mean of the pixels that each pixel of a picture `width` wide covers; as it is when it is not wider.
Image shrunk(const Image& image, int width) {
  if (image.width() <= width) return image;
  const double height = static_cast<double>(image.height()) * width / image.width();
  return resized(image, width, std::max(1, static_cast<int>(std::lround(height))),
                 {.filter = {.kind = FilterKind::box}});
}

Image montage_of(const std::vector<Image>& inputs, const std::vector<std::string>& names, const TonemapOptions& o,
                 const FractionSink& progress) {
  ToneSettings settings = common_settings(o);
  std::vector<draw::Panel> panels;
  for (const std::string& name : names) {
    if (o.operators.empty() && name == tone::Ocio::name && !tone::Ocio::available()) continue;
    settings.op = configured_operator(name, {});
    panels.push_back({name, shrunk(tonemap(inputs.front(), settings), o.tile_width)});
    if (progress) progress(static_cast<double>(panels.size()) / static_cast<double>(names.size()));
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
  if (o.inputs.empty()) throw CLI::RequiredError("input");
  if (o.outputs.empty()) throw CLI::RequiredError("--output");
  if (o.operators.size() > 1 && !o.montage) throw Error("--operator: several need --montage");
  if (o.montage && !o.assignments.empty()) throw Error("--set belongs to one operator, not to --montage");
  if (o.inputs.size() > 1 && (o.montage || o.operators != std::vector<std::string>{tone::Mertens::name}))
    throw Error("several images are a stack of exposures, for which there is --operator mertens");
  check_images(o.outputs);
}

int run(const TonemapOptions& o) {
  if (o.list) {
    print_operators(o.json);
    return done;
  }
  check(o);
  const FractionSink progress = start_work(o.work), reading = part_of(progress, 0, 0.3);
  std::vector<Image> inputs;
  for (const std::string& path : o.inputs) {
    inputs.push_back(read_image(path));
    if (reading) reading(static_cast<double>(inputs.size()) / static_cast<double>(o.inputs.size()));
  }
  const Image shown =
      o.montage ? montage_of(inputs, o.operators.empty() ? tone_operator_names() : o.operators, o,
                             part_of(progress, 0.3, 0.7))
                : mapped(std::move(inputs), o.operators.empty() ? tone::Photographic::name : o.operators.front(), o);
  write_images(o.outputs, shown, {}, part_of(progress, 0.7, 1));
  return done;
}

}  // namespace

std::function<int()> add_tonemap(CLI::App& app) {
  static TonemapOptions o;
  const std::string names = fmt::format("{}", fmt::join(tone_operator_names(), ", "));
  app.add_option("input", o.inputs, "Radiance map; several images are a stack of exposures (mertens)")
      ->type_name("FILE");
  add_outputs(app, o.outputs, "Image to write, by extension");
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
                whole_number(0, 100));
  expect_number(app.add_option("--tile-width", o.tile_width, "Of the montage, at most, pixels")->capture_default_str(),
                whole_number(16, 4096));
  add_work_options(app, o.work);
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
