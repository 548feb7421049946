#include "render_options.h"

#include "exposure_flag.h"
#include "number_range.h"
#include "outputs.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <string_view>

namespace lambert::cli {
namespace {

constexpr int default_samples = 64, most_samples = std::numeric_limits<int>::max() / 2, most_threads = 4096;

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

/// Whole numbers parted by `separators`, one character between each two: "1920x1080" by "x".
std::vector<int> parse_numbers(const std::string& flag, const std::string& text, const std::string& separators,
                               const char* expected) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i <= separators.size(); ++i) {
    int n = 0;
    const auto [next, status] = std::from_chars(at, end, n);
    const bool separated = i == separators.size() ? next == end : next != end && *next == separators[i];
    if (status != std::errc() || !separated) throw Error(flag + ": expected " + expected + ", got '" + text + "'");
    numbers.push_back(n);
    at = next + 1;
  }
  return numbers;
}

PixelRect parse_crop(const std::string& text) {
  const auto n = parse_numbers("--crop", text, ",,,", "x0,y0,x1,y1 in pixels");
  return {{n[0], n[1]}, {n[2], n[3]}};
}

/// Whether a PNG says that this program made it (its tEXt chunk "software").
bool is_our_picture(const std::filesystem::path& path) {
  using namespace std::string_view_literals;
  return MappedFile(path).text().substr(0, 4096).find("software\0lambert "sv) != std::string_view::npos;
}

/// "out.png", or the scene's name as PNG beside it. Textures often have their scene's name: a file that is not ours is
/// not replaced unless the user names it.
std::string default_output(const std::string& scene) {
  if (scene.empty()) return "out.png";
  const auto path = std::filesystem::path(scene).replace_extension(".png");
  if (std::filesystem::exists(path) && !is_our_picture(path))
    throw Error(path.string() + " exists and was not made by lambert: name the output with -o");
  return path.string();
}

}  // namespace

void add_render_options(CLI::App& app, RenderOptions& o) {
  add_scene_options(app, o.scene);
  add_outputs(app, o.outputs, "Image to write: " + joined(image_extensions()));
  app.add_option("--method", o.method, "How to render (see 'lambert methods')")->capture_default_str();
  app.add_option("--set", o.method_settings, "A setting of the method, key=value; several allowed")
      ->allow_extra_args(false);
  expect_number(app.add_option("--spp", o.samples_per_pixel, "Samples per pixel (at most, with --target-error)"),
                whole_number(1, most_samples));
  expect_number(app.add_option("--time-limit", o.time_limit, "Stop after this many seconds"),
                {.expected = "a number of seconds, 0 or more"});
  expect_number(app.add_option("--target-error", o.target_error,
                               "Spend samples where needed until a pixel's relative error is this (0.02: two percent)"),
                {.expected = "a number, 0 or more"});
  add_seed(app, o.seed, "Another seed, another noise");
  expect_number(app.add_option("--threads", o.threads, "0: all cores")->capture_default_str(),
                whole_number(0, most_threads));
  app.add_option("--resolution", o.resolution, "WIDTHxHEIGHT in pixels");
  app.add_option("--crop", o.crop, "Render only x0,y0,x1,y1 (pixels, the last ones exclusive)");
  app.add_option("--camera", o.camera, "Name or number of the camera; the first by default");
  app.add_option("--sampler", o.sampler, "Sample points: " + joined(sampler_names()));
  app.add_option("--filter", o.filter, "Pixel filter: " + joined(filter_names()));
  app.add_option("--lights", o.lights, "Choice of lights: " + joined(light_strategy_names()));
  app.add_option("--aov", o.aovs, "Extra layers of an EXR: " + joined(aov_names()) + ", or all")
      ->delimiter(',')
      ->allow_extra_args(false);
  expect_number(
      app.add_option("--pass-size", o.pass_size, "Samples per pixel and pass (0: growing); does not change the image")
          ->capture_default_str(),
      whole_number(0, most_samples));
  app.add_option("--exposure", o.exposure, "Stops, for display formats; auto, or auto with stops: auto+1")
      ->capture_default_str();
  app.add_option("--tonemap", o.tonemap, "For display formats: " + joined(tone_operator_names()))
      ->capture_default_str();
  app.add_flag("--denoise", o.denoise, "Remove the noise that is left (see 'lambert denoise'); biased");
  add_work_options(app, o.work);
  add_output(app, "--stats", o.stats, "Write times, counts and rates as JSON");
  app.add_flag("--verbose", o.verbose, "Say more");
}

std::optional<Vec2i> requested_resolution(const RenderOptions& options) {
  if (options.resolution.empty()) return std::nullopt;
  const auto size = parse_numbers("--resolution", options.resolution, "x", "WIDTHxHEIGHT such as 1920x1080");
  if (size[0] < 1 || size[1] < 1 || size[0] > 65536 || size[1] > 65536)
    throw Error("--resolution: expected sizes from 1 to 65536, got '" + options.resolution + "'");
  return Vec2i(size[0], size[1]);
}

Camera choose_camera(const std::vector<Camera>& cameras, const RenderOptions& options) {
  std::size_t chosen = 0;
  if (!options.camera.empty()) {
    const auto named =
        std::find_if(cameras.begin(), cameras.end(), [&](const Camera& c) { return c.name == options.camera; });
    if (named != cameras.end()) {
      chosen = static_cast<std::size_t>(named - cameras.begin());
    } else {
      const char* const end = options.camera.data() + options.camera.size();
      const auto [next, status] = std::from_chars(options.camera.data(), end, chosen);
      if (status != std::errc() || next != end || chosen >= cameras.size()) {
        std::vector<std::string> names;
        for (const Camera& c : cameras) names.push_back(c.name);
        throw Error("--camera: unknown camera " + unknown_word(options.camera, names) + ", or a number below " +
                    std::to_string(cameras.size()));
      }
    }
  }
  const auto resolution = requested_resolution(options);
  return resolution ? cameras[chosen].with_resolution(*resolution) : cameras[chosen];
}

RenderSettings render_settings(const RenderOptions& o, const SceneFileSettings& file) {
  RenderSettings s;
  const bool limited = o.time_limit > 0;
  s.samples_per_pixel =
      o.samples_per_pixel.value_or(limited ? most_samples : file.samples_per_pixel.value_or(default_samples));
  s.time_limit_seconds = o.time_limit;
  s.target_error = o.target_error;
  s.seed = o.seed;
  s.sampler = sampler_kind(!o.sampler.empty() ? o.sampler : file.sampler.value_or("sobol"));
  if (file.filter) s.filter = *file.filter;
  if (!o.filter.empty()) s.filter = FilterSettings{.kind = filter_kind(o.filter)};
  if (!o.crop.empty()) s.crop = parse_crop(o.crop);
  const auto add_once = [&](Aov a) {
    if (std::ranges::find(s.aovs, a) == s.aovs.end()) s.aovs.push_back(a);
  };
  for (const std::string& name : o.aovs) {
    if (name == "all")
      for (const std::string& each : aov_names()) add_once(aov(each));
    else
      add_once(aov(name));
  }
  if (o.denoise) add_once(Aov::denoising);
  s.pass_size = o.pass_size;
  return s;
}

std::unique_ptr<Method> configured_method(const RenderOptions& options, const SceneFileSettings& file) {
  auto method = make_method(options.method);
  SettingTable table = method->settings();
  const bool has_depth = std::any_of(table.settings().begin(), table.settings().end(),
                                     [](const Setting& s) { return s.key == "max-depth"; });
  if (file.max_depth && has_depth) table.set("max-depth", std::to_string(*file.max_depth));
  for (const std::string& assignment : options.method_settings) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos) throw Error("--set: expected key=value, got '" + assignment + "'");
    table.set(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  return method;
}

std::vector<std::string> output_paths(const RenderOptions& options) {
  std::vector<std::string> paths = options.outputs;
  if (paths.empty()) paths.push_back(default_output(options.scene.file));
  check_images(paths);
  if (!options.stats.empty()) check_writable(options.stats);
  return paths;
}

ToneSettings tone_settings(const RenderOptions& options) {
  ToneSettings settings{.op = tone_operator(options.tonemap)};
  set_exposure(settings, options.exposure);
  return settings;
}

}  // namespace lambert::cli
