#pragma once
/// The flags of `lambert render`, shared with every command that renders.

#include "cli_fwd.h"

#include "lambert/camera/camera.h"
#include "lambert/image/tonemap/tonemap.h"
#include "lambert/render/render.h"

#include "load_scene.h"
#include "work.h"

#include <optional>
#include <string>
#include <vector>

namespace lambert::cli {

struct RenderOptions {
  SceneOptions scene;
  std::vector<std::string> outputs;
  std::string method = "path";
  std::vector<std::string> method_settings;  // key=value
  std::string camera, resolution, crop, sampler, filter, lights;
  std::vector<std::string> aovs;
  std::optional<int> samples_per_pixel;
  double time_limit = 0, target_error = 0;
  std::uint64_t seed = 0;
  std::size_t threads = 0;
  int pass_size = 0;
  std::string exposure = "0", tonemap = "linear";
  std::string stats;
  WorkOptions work;
  bool verbose = false, denoise = false;
};

void add_render_options(CLI::App& app, RenderOptions& options);

/// What --resolution says, if anything. Throws Error.
std::optional<Vec2i> requested_resolution(const RenderOptions& options);

/// The camera that was asked for by name or number (the first by default), at the resolution asked for. Throws Error.
Camera choose_camera(const std::vector<Camera>& cameras, const RenderOptions& options);

/// Flags over what the scene file says over defaults. Throws Error.
RenderSettings render_settings(const RenderOptions& options, const SceneFileSettings& file);

/// The method with its settings: those of the flags over max_depth of the file. Throws Error.
std::unique_ptr<Method> configured_method(const RenderOptions& options, const SceneFileSettings& file);

/// Where to write: as -o says, or as PNG beside the scene. Throws Error, before any work is done, when an output or the
/// statistics could not be written there.
std::vector<std::string> output_paths(const RenderOptions& options);

ToneSettings tone_settings(const RenderOptions& options);

}  // namespace lambert::cli
