#include "command.h"
#include "interrupt.h"
#include "load_scene.h"
#include "print_path.h"
#include "render_options.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/log.h"
#include "lambert/base/parallel.h"
#include "lambert/image/denoise/denoise.h"
#include "lambert/image/io.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace lambert::cli {
namespace {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Whether `write` did; its error is logged, so that what else there is to write is written.
bool written(const std::function<void()>& write) {
  try {
    write();
    return true;
  } catch (const std::exception& e) {
    log::error(e.what());
    return false;
  }
}

/// False when one of them could not be written.
bool write_outputs(const std::vector<std::string>& paths, const RenderOptions& options, const RenderSettings& settings,
                   const Film& film) {
  Image image = film.develop();
  image.metadata["software"] = "lambert " LAMBERT_VERSION;
  image.metadata["scene"] = options.scene.file.empty() ? "Cornell box" : options.scene.file;
  image.metadata["method"] = options.method;
  image.metadata["seed"] = std::to_string(settings.seed);
  image.metadata["samples"] = std::to_string(film.total_samples() / film.crop().area());
  const bool asked_for_layers = std::any_of(options.aovs.begin(), options.aovs.end(),
                                            [](const auto& name) { return name == "denoising" || name == "all"; });
  if (options.denoise) image = denoise_image(image, {.keep_layers = asked_for_layers});
  bool all = true;
  for (const std::string& path : paths)
    all &= written([&] {
      write_image(path, is_radiance_format(path) ? image : tonemap(image, tone_settings(options)));
      print_path(path);
    });
  return all;
}

void write_statistics(const std::string& path, const RenderStatistics& s, double load_seconds,
                      double render_cpu_seconds) {
  const double samples = static_cast<double>(s.samples), rays = static_cast<double>(s.rays);
  const nlohmann::ordered_json j{{"load_seconds", load_seconds},
                                 {"first_sample_seconds", load_seconds + s.first_sample_seconds},
                                 {"render_seconds", s.seconds},
                                 {"render_cpu_seconds", render_cpu_seconds},
                                 {"samples", s.samples},
                                 {"rays", s.rays},
                                 {"samples_per_second", samples / s.seconds},
                                 {"samples_per_cpu_second", samples / render_cpu_seconds},
                                 {"rays_per_second", rays / s.seconds},
                                 {"peak_megabytes", peak_megabytes()},
                                 {"threads", thread_count()},
                                 {"interrupted", s.interrupted}};
  write_atomically(path, j.dump(2) + "\n");
}

int interrupted_with_nothing() {
  log::warn("interrupted before the first sample; nothing is written");
  return interrupted;
}

int run(const RenderOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (options.verbose) log::set_level(log::Level::debug);
  const ProgressSink progress = progress_of(options.work);
  const std::vector<std::string> paths = output_paths(options);
  if (!options.aovs.empty() &&
      std::none_of(paths.begin(), paths.end(), [](const auto& path) { return writes_exr(path); }))
    log::warn("--aov adds layers to an EXR, and none is written");
  tone_settings(options);
  const std::stop_token stop = stop_on_interrupt();
  set_thread_count(options.threads);

  Notes notes;
  SceneGraph graph = load_scene(options.scene, notes, requested_resolution(options).value_or(default_resolution));
  print_notes(notes);
  if (stop.stop_requested()) return interrupted_with_nothing();
  const RenderSettings settings = render_settings(options, graph.settings);
  const auto method = configured_method(options, graph.settings);
  const Camera camera = choose_camera(graph.cameras(), options);
  const std::string lights = !options.lights.empty() ? options.lights : graph.settings.light_strategy.value_or("tree");
  const Scene scene = compile(std::move(graph), {.light_strategy = light_strategy(lights)});

  const double load_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double cpu_before = cpu_seconds();
  const RenderResult result = render(scene, camera, *method, settings, progress, stop);
  const double render_cpu = cpu_seconds() - cpu_before;

  if (result.film.total_samples() == 0) return interrupted_with_nothing();

  bool all = write_outputs(paths, options, settings, result.film);
  if (!options.stats.empty())
    all &= written([&] { write_statistics(options.stats, result.statistics, load_seconds, render_cpu); });
  if (result.statistics.interrupted) log::warn(all ? "interrupted; what was done is saved" : "interrupted");
  if (!all) return failed;
  return result.statistics.interrupted ? interrupted : done;
}

}  // namespace

std::function<int()> add_render(CLI::App& app) {
  static RenderOptions options;
  add_render_options(app, options);
  app.footer(
      "Examples:\n"
      "  lambert render kitchen.glb -o k.exr -o k.png --time-limit 60\n"
      "  lambert render box.pbrt --spp 256 --aov albedo,normal,depth -o box.exr\n"
      "  lambert render box.pbrt --target-error 0.02 --spp 4096\n"
      "  lambert render kitchen.glb --spp 16 --denoise\n"
      "  lambert render --set max-depth=8 --filter box");
  return [] { return run(options); };
}

}  // namespace lambert::cli
