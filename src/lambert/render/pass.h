#pragma once
#include "lambert/render/film.h"
#include "lambert/render/method.h"

#include <atomic>
#include <cstdint>
#include <functional>

namespace lambert {

/// What a pass needs to know; shared by all its threads.
struct PassContext {
  const Camera& camera;
  const Method& method;
  const FilterSampler& filter;
  SamplerSettings sampler;
  std::atomic<std::uint64_t>& samples;
  std::atomic<std::uint64_t>& rays;
};

/// Adds samples [first(pixel), last(pixel)) of each pixel to the film, tile by tile in parallel. `keep_going` is asked
/// before each row of a tile; when it says no, the rest of the tile is left as it is. Every pixel stays valid.
void sample_tiles(const PassContext& context, Film& film, const std::function<std::uint32_t(Vec2i)>& samples_wanted,
                  const std::function<bool()>& keep_going);

/// Makes the emission of the film's guides (layer `denoising`) sharp where it is neither even nor agreed on by both
/// halves: lamps in mirrors and in the lens, edges of lamps. There it gets samples of its own, which cost a camera ray
/// each, up to eight times those of the pixel and 256. The image itself does not change.
void refine_emission(const PassContext& context, Film& film, const std::function<bool()>& keep_going);

}  // namespace lambert
