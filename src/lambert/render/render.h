#pragma once
#include "lambert/base/progress.h"
#include "lambert/render/film.h"
#include "lambert/render/method.h"

#include <cstdint>
#include <optional>
#include <stop_token>

namespace lambert {

struct RenderSettings {
  int samples_per_pixel = 64;     ///< at most, per pixel
  double time_limit_seconds = 0;  ///< 0: none; one sample of each pixel is taken in any case
  double target_error = 0;        ///< relative standard error of a pixel at which it is done; 0: not adaptive
  std::uint64_t seed = 0;
  SamplerKind sampler = SamplerKind::sobol;
  FilterSettings filter;
  std::optional<PixelRect> crop;
  std::vector<Aov> aovs;
  int pass_size = 0;  ///< samples per pixel and pass after a first pass of 1; 0: 1, 1, 2, 4, 8, 16, 16 …
};

struct RenderStatistics {
  double seconds = 0;
  double first_sample_seconds = 0;  ///< until the first pass was done
  std::uint64_t samples = 0, rays = 0;
  bool interrupted = false;  ///< stopped before its samples, time or error were reached
};

struct RenderResult {
  Film film;
  RenderStatistics statistics;
};

/// Refines a film pass after pass until samples, time or error are reached or `stop` is requested. The image depends on
/// scene, camera, method and settings (time limits apart), not on threads or passes. Throws Error for settings out of
/// range.
RenderResult render(const Scene& scene, const Camera& camera, Method& method, const RenderSettings& settings,
                    const ProgressSink& progress = {}, std::stop_token stop = {});

}  // namespace lambert
