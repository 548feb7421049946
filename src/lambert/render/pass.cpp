#include "lambert/render/pass.h"

#include "lambert/base/parallel.h"

#include <algorithm>

namespace lambert {
namespace {

constexpr int tile_size = 16;

// Dimensions of a sample: the pixel filter, the lens, the shutter; then the method's own.
constexpr std::uint32_t lens_dimension = 1, time_dimension = 2, method_dimension = 3;

FilmSample take_sample(const PassContext& c, const Film& film, Vec2i pixel, std::uint32_t index, std::uint32_t& rays) {
  Sampler sampler(c.sampler, pixel, index);
  const FilterSampler::Sample filtered = c.filter.sample(sampler.next2());
  Vec2 lens(0.5f);
  if (c.camera.has_lens()) {
    sampler.set_dimension(lens_dimension);
    lens = sampler.next2();
  }
  float time = 0;
  if (c.camera.has_shutter()) {
    sampler.set_dimension(time_dimension);
    time = sampler.next();
  }
  sampler.set_dimension(method_dimension);

  const CameraRay ray = c.camera.ray(Vec2(pixel) + 0.5f + filtered.offset, lens, time);
  const Method::Estimate estimate = c.method.radiance(ray, sampler, film.keeps_features());
  rays += estimate.rays;
  FilmSample result{.radiance = estimate.radiance, .weight = filtered.weight};
  if (film.keeps_features()) {
    result.features = estimate.features;
    result.features.depth = c.camera.axis_depth(ray.ray, estimate.features.depth);
  }
  return result;
}

}  // namespace

void sample_tiles(const PassContext& context, Film& film, const std::function<std::uint32_t(Vec2i)>& samples_wanted,
                  const std::function<bool()>& keep_going) {
  const PixelRect crop = film.crop();
  const Vec2i tiles = (crop.size() + (tile_size - 1)) / tile_size;
  parallel_for(static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y), [&](std::size_t i) {
    const auto column = static_cast<int>(i % static_cast<std::size_t>(tiles.x));
    const auto row = static_cast<int>(i / static_cast<std::size_t>(tiles.x));
    const Vec2i from = crop.min + tile_size * Vec2i(column, row);
    const Vec2i to(std::min(from.x + tile_size, crop.max.x), std::min(from.y + tile_size, crop.max.y));
    for (int y = from.y; y < to.y && keep_going(); ++y) {
      std::uint32_t samples = 0, rays = 0;
      for (int x = from.x; x < to.x; ++x) {
        const Vec2i pixel(x, y);
        const std::uint32_t wanted = samples_wanted(pixel);
        for (std::uint32_t s = film.sample_count(pixel); s < wanted; ++s, ++samples)
          film.add(pixel, take_sample(context, film, pixel, s, rays));
      }
      context.samples.fetch_add(samples, std::memory_order_relaxed);
      context.rays.fetch_add(rays, std::memory_order_relaxed);
    }
  });
}

}  // namespace lambert
