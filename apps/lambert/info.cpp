#include "command.h"
#include "image/verb.h"
#include "load_scene.h"

#include "lambert/image/io.h"
#include "lambert/scene/scene.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace lambert::cli {
namespace {

struct Options {
  SceneOptions scene;
  bool json = false;
};

nlohmann::ordered_json as_json(Vec3 v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json describe(const SceneOptions& options) {
  Notes notes;
  SceneGraph graph = load_scene(options, notes);
  nlohmann::ordered_json j;
  j["scene"] = options.file.empty() ? "built-in Cornell box" : options.file;
  j["nodes"] = graph.node_count();
  j["geometries"] = graph.geometry_count();
  j["materials"] = graph.materials.size();
  j["textures"] = graph.textures.size();
  for (const Camera& c : graph.cameras())
    j["cameras"].push_back({{"name", c.name},
                            {"resolution", {c.resolution.x, c.resolution.y}},
                            {"position", as_json(c.to_world.point(Vec3(0)))}});
  const Scene scene = compile(std::move(graph));
  j["triangles"] = scene.triangle_count();
  j["lights"] = scene.lights().size();
  j["bounds"] = {{"min", as_json(scene.bounds().min)}, {"max", as_json(scene.bounds().max)}};
  j["notes"] = nlohmann::json::array();
  for (const auto& [note, count] : notes.counts()) j["notes"].push_back({{"note", note}, {"count", count}});
  return j;
}

void print_text(const nlohmann::ordered_json& j) {
  for (const auto& [key, value] : j.items()) {
    if (key == "notes" || key == "cameras") continue;
    fmt::print("{:<11} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  if (j.contains("cameras"))
    for (const auto& c : j["cameras"])
      fmt::print("camera      {} at {}, {}\n", c["name"].dump(), c["position"].dump(), c["resolution"].dump());
  for (const auto& n : j["notes"])
    fmt::print("note        {}{}\n", n["note"].get<std::string>(),
               n["count"] > 1 ? fmt::format(" ({} times)", n["count"].get<int>()) : "");
}

}  // namespace

std::function<int()> add_info(CLI::App& app) {
  static Options options;
  add_scene_options(app, options.scene);
  app.add_flag("--json", options.json, "Print JSON");
  return [] {
    if (!options.scene.file.empty() && is_image_file(options.scene.file)) {
      print_image_info(options.scene.file, options.json);
      return done;
    }
    const auto description = describe(options.scene);
    if (options.json)
      fmt::print("{}\n", description.dump(2));
    else
      print_text(description);
    return done;
  };
}

}  // namespace lambert::cli
