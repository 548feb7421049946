#pragma once
#include "cli_fwd.h"

#include "lambert/base/notes.h"
#include "lambert/scene/scene.h"

#include <string>

namespace lambert::cli {

/// Which scene, as every command that reads one takes it.
struct SceneOptions {
  std::string file;         ///< empty: the built-in Cornell box
  std::string environment;  ///< an image, or "studio"; empty: what the scene has
  float time = 0;
  std::string variant;
};
void add_scene_options(CLI::App& app, SceneOptions& options);

/// Reads the scene and adds what it lacks; what was ignored, approximated or added is in `notes`. A camera that is
/// added frames for `resolution`.
SceneGraph load_scene(const SceneOptions& options, Notes& notes, Vec2i resolution = default_resolution);

/// One line a note on standard error.
void print_notes(const Notes& notes);

}  // namespace lambert::cli
