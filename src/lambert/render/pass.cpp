#include "lambert/render/pass.h"

#include "lambert/base/parallel.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace lambert {
namespace {

constexpr int tile_size = 16;

// Dimensions of a sample: the pixel filter, the lens, the shutter; then the method's own.
constexpr std::uint32_t lens_dimension = 1, time_dimension = 2, method_dimension = 3;

/// A camera ray, with the sampler at the method's first dimension.
struct CameraSample {
  Sampler sampler;
  float weight = 1;
  CameraRay ray;

  CameraSample(const PassContext& c, Vec2i pixel, std::uint32_t index) : sampler(c.sampler, pixel, index) {
    const FilterSampler::Sample filtered = c.filter.sample(sampler.next2());
    weight = filtered.weight;
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
    ray = c.camera.ray(Vec2(pixel) + 0.5f + filtered.offset, lens, time);
  }
};

FilmSample take_sample(const PassContext& c, const Film& film, Vec2i pixel, std::uint32_t index, std::uint32_t& rays) {
  CameraSample camera(c, pixel, index);
  const Method::Estimate estimate = c.method.radiance(camera.ray, camera.sampler, film.keeps_features());
  rays += estimate.rays;
  FilmSample result{.radiance = estimate.radiance, .weight = camera.weight};
  if (film.keeps_features()) {
    result.features = estimate.features;
    result.features.depth = c.camera.axis_depth(camera.ray.ray, estimate.features.depth);
  }
  return result;
}

/// Calls row(y, first x, last x) for the rows of all tiles, tiles in parallel, each from its top.
template <class Row>
void for_rows_of_tiles(const PixelRect& crop, const std::function<bool()>& keep_going, Row row_of_tile) {
  const Vec2i tiles = (crop.size() + (tile_size - 1)) / tile_size;
  parallel_for(static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y), [&](std::size_t i) {
    const auto column = static_cast<int>(i % static_cast<std::size_t>(tiles.x));
    const auto row = static_cast<int>(i / static_cast<std::size_t>(tiles.x));
    const Vec2i from = crop.min + tile_size * Vec2i(column, row);
    const Vec2i to(std::min(from.x + tile_size, crop.max.x), std::min(from.y + tile_size, crop.max.y));
    for (int y = from.y; y < to.y && keep_going(); ++y) row_of_tile(y, from.x, to.x);
  });
}

/// Whether emission around a pixel varies by a tenth of what is seen there.
bool has_uneven_emission(const Film& film, Vec2i pixel) {
  constexpr int radius = 2;
  const PixelRect& crop = film.crop();
  float least = std::numeric_limits<float>::infinity(), most = 0, seen = 0;
  int count = 0;
  for (int y = std::max(pixel.y - radius, crop.min.y); y <= std::min(pixel.y + radius, crop.max.y - 1); ++y)
    for (int x = std::max(pixel.x - radius, crop.min.x); x <= std::min(pixel.x + radius, crop.max.x - 1); ++x) {
      for (const Rgb e : film.emission({x, y}))
        least = std::min(least, luminance(e)), most = std::max(most, luminance(e));
      seen += luminance(film.mean({x, y}));
      ++count;
    }
  return most - least > 0.1f * seen / static_cast<float>(count);
}

}  // namespace

void sample_tiles(const PassContext& context, Film& film, const std::function<std::uint32_t(Vec2i)>& samples_wanted,
                  const std::function<bool()>& keep_going) {
  for_rows_of_tiles(film.crop(), keep_going, [&](int y, int first, int last) {
    std::uint32_t samples = 0, rays = 0;
    for (int x = first; x < last; ++x) {
      const Vec2i pixel(x, y);
      const std::uint32_t wanted = samples_wanted(pixel);
      for (std::uint32_t s = film.sample_count(pixel); s < wanted; ++s, ++samples)
        film.add(pixel, take_sample(context, film, pixel, s, rays));
    }
    context.samples.fetch_add(samples, std::memory_order_relaxed);
    context.rays.fetch_add(rays, std::memory_order_relaxed);
  });
}

void refine_emission(const PassContext& context, Film& film, const std::function<bool()>& keep_going) {
  constexpr std::uint32_t most_samples = 256;
  const PixelRect& crop = film.crop();
  std::vector<char> uneven(crop.area());
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y - crop.min.y) * static_cast<std::size_t>(crop.size().x) +
           static_cast<std::size_t>(x - crop.min.x);
  };
  for_rows_of_tiles(crop, keep_going, [&](int y, int first, int last) {
    for (int x = first; x < last; ++x) uneven[index(x, y)] = has_uneven_emission(film, {x, y});
  });
  for_rows_of_tiles(crop, keep_going, [&](int y, int first, int last) {
    std::uint32_t rays = 0;
    for (int x = first; x < last; ++x) {
      if (!uneven[index(x, y)]) continue;
      const std::uint32_t done = film.sample_count({x, y}), wanted = std::min(8 * done, most_samples);
      for (std::uint32_t s = done; s < wanted; ++s) {
        CameraSample camera(context, {x, y}, s);
        const Method::Estimate estimate = context.method.guide(camera.ray, camera.sampler);
        rays += estimate.rays;
        film.add_emission({x, y}, s < wanted / 2 ? 0 : 1, estimate.features.guide.emission, camera.weight);
      }
    }
    context.rays.fetch_add(rays, std::memory_order_relaxed);
  });
}

}  // namespace lambert
