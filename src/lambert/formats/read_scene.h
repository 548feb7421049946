#pragma once
#include "lambert/base/notes.h"
#include "lambert/scene/scene_graph.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lambert {

struct ReadSettings {
  float time = 0;       ///< seconds into animations (skins, morph targets, node transforms)
  std::string variant;  ///< KHR_materials_variants; empty: the default materials
};

/// Reads glTF (.gltf .glb), pbrt-v4 text (.pbrt .pbrt.gz), OBJ (.obj) or PLY (.ply .ply.gz), by extension. What is
/// ignored or approximated goes into `notes`. Throws Error with file, line and column (or byte offset) and what was
/// expected.
SceneGraph read_scene(const std::filesystem::path& path, const ReadSettings& settings, Notes& notes);

std::vector<std::string> scene_extensions();

}  // namespace lambert
