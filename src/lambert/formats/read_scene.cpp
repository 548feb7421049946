#include "lambert/formats/read_scene.h"

#include "lambert/base/error.h"
#include "lambert/formats/input_file.h"
#include "lambert/formats/readers.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace lambert {
namespace {

/// ".obj", or ".ply.gz" with the extension below.
std::string full_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  if (extension == ".gz") extension = path.stem().extension().string() + extension;
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

SceneGraph ply_scene(TriangleMesh mesh) {
  SceneGraph graph;
  Material grey;
  grey.name = "default";
  Surface surface;
  surface.material = graph.materials.add(std::move(grey));
  const NodeId node = graph.add_node(graph.root(), mesh.name);
  surface.geometry = graph.add_geometry(std::move(mesh));
  graph.add_surface(node, surface);
  return graph;
}

SceneGraph read_by_extension(const std::filesystem::path& path, const ReadSettings& settings, Notes& notes) {
  const std::string extension = full_extension(path), name = path.string();
  const std::vector<std::string> known = scene_extensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    throw Error(name + ": unknown kind of scene " + unknown_word(extension, known));
  }
  const bool gltf = extension == ".gltf" || extension == ".glb";
  if (!gltf && !settings.variant.empty()) notes.add("--variant is ignored: only glTF files have variants");
  const InputFile file(path);
  const std::filesystem::path folder = path.parent_path();
  if (gltf) return read_gltf(file.bytes(), name, folder, settings, notes);
  if (extension.starts_with(".pbrt")) return read_pbrt(file.text(), name, folder, notes);
  if (extension.starts_with(".obj")) return read_obj(file.text(), name, folder, notes);
  return ply_scene(read_ply(file.bytes(), name, notes));
}

}  // namespace

SceneGraph read_scene(const std::filesystem::path& path, const ReadSettings& settings, Notes& notes) {
  try {
    SceneGraph graph = read_by_extension(path, settings, notes);
    graph.name = path.filename().string();
    return graph;
  } catch (const Error& e) {
    // What the scene graph refuses knows no file.
    if (std::string_view(e.what()).find(path.filename().string()) != std::string_view::npos) throw;
    throw Error(path.string() + ": " + e.what());
  }
}

std::vector<std::string> scene_extensions() {
  return {".gltf", ".glb", ".pbrt", ".pbrt.gz", ".obj", ".obj.gz", ".ply", ".ply.gz"};
}

}  // namespace lambert
