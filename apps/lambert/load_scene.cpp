#include "load_scene.h"

#include "lambert/base/log.h"
#include "lambert/formats/read_scene.h"
#include "lambert/scene/cornell_box.h"
#include "lambert/scene/scene.h"

#include <fmt/format.h>

namespace lambert::cli {

void add_scene_options(CLI::App& app, SceneOptions& options) {
  app.add_option("scene", options.file, "glTF (.gltf .glb), pbrt-v4 (.pbrt), OBJ or PLY file; none: the Cornell box");
  app.add_option("--time", options.time, "Seconds into the scene's animation")->capture_default_str();
  app.add_option("--variant", options.variant, "Material variant (glTF KHR_materials_variants)");
}

SceneGraph load_scene(const SceneOptions& options, Notes& notes) {
  if (options.file.empty()) return cornell_box();
  SceneGraph graph = read_scene(options.file, {options.time, options.variant}, notes);
  add_missing_camera_and_light(graph, notes);
  return graph;
}

void print_notes(const Notes& notes) {
  for (const auto& [note, count] : notes.counts())
    log::info(count > 1 ? fmt::format("{} ({} times)", note, count) : note);
}

}  // namespace lambert::cli
