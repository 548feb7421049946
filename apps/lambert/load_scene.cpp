#include "load_scene.h"

#include "number_range.h"

#include "lambert/base/error.h"
#include "lambert/base/log.h"
#include "lambert/formats/read_scene.h"
#include "lambert/image/io.h"
#include "lambert/scene/cornell_box.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <limits>
#include <utility>

namespace lambert::cli {
namespace {

EnvironmentLight read_environment(const std::string& name) {
  if (name == "studio") return studio_environment();
  Image image = displayed(read_image(name));
  try {
    return {std::move(image), EnvironmentMapping::lat_long, Rgb(1.0f), Transform()};
  } catch (const Error& e) {
    throw Error(name + ": " + e.what());
  }
}

}  // namespace

void add_scene_options(CLI::App& app, SceneOptions& options) {
  app.add_option("scene", options.file, "glTF (.gltf .glb), pbrt-v4 (.pbrt), OBJ or PLY file; none: the Cornell box");
  app.add_option("--environment", options.environment,
                 "Light from all around, beside the scene's: a latitude-longitude image (.hdr, .exr), or 'studio'");
  expect_number(
      app.add_option("--time", options.time, "Seconds into the scene's animation")->capture_default_str(),
      {.expected = "a number of seconds, 0 or more", .below = static_cast<double>(std::numeric_limits<float>::max())});
  app.add_option("--variant", options.variant, "Material variant (glTF KHR_materials_variants)");
}

SceneGraph load_scene(const SceneOptions& options, Notes& notes, Vec2i resolution) {
  SceneGraph graph =
      options.file.empty() ? cornell_box() : read_scene(options.file, {options.time, options.variant}, notes);
  if (!options.environment.empty()) graph.add_light(read_environment(options.environment));
  add_missing_camera_and_light(graph, notes, resolution);
  return graph;
}

void print_notes(const Notes& notes) {
  for (const auto& [note, count] : notes.counts())
    log::info(count > 1 ? fmt::format("{} ({} times)", note, count) : note);
}

}  // namespace lambert::cli
