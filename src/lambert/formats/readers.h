#pragma once
/// One reader per format; read_scene() chooses. Each also reads from memory, for tests and fuzzing.

#include "lambert/formats/read_scene.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace lambert {

/// glTF 2.0 as JSON or GLB. `folder` is where relative URIs are looked up.
SceneGraph read_gltf(std::span<const std::byte> data, const std::string& name, const std::filesystem::path& folder,
                     const ReadSettings& settings, Notes& notes);
/// pbrt-v4 text. Include and Import are looked up in `folder`.
SceneGraph read_pbrt(std::string_view text, const std::string& name, const std::filesystem::path& folder, Notes& notes);
SceneGraph read_obj(std::string_view text, const std::string& name, const std::filesystem::path& folder, Notes& notes);
/// Fast for huge binary files.
TriangleMesh read_ply(std::span<const std::byte> data, const std::string& name, Notes& notes);

}  // namespace lambert
