#include "lambert/lab/sampled_image.h"

#include "lambert/base/hash.h"
#include "lambert/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace lambert::lab {

Image sampled(const Scene& scene, int width, int height, const PixelSampling& sampling) {
  Image image(width, height, rgb_channels());
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      const std::uint64_t seed =
          hash_values(sampling.seed, static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y));
      Rgb sum;
      const auto points = pattern_points(sampling.pattern, sampling.samples, seed);
      for (const Vec2 p : points) sum += scene({x + static_cast<double>(p.x), y + static_cast<double>(p.y)});
      image.set_rgb(x, y, sum / static_cast<float>(points.size()));
    }
  });
  return image;
}

Image sampled_by_tiles(const Scene& scene, int width, int height, const PixelSampling& sampling) {
  constexpr int tile = 16;
  constexpr double reach = 1.5, sigma = 0.5;
  struct Weighted {
    Vec2d offset;  // from the pixel's corner
    float weight;
  };
  // Which points of the tile and of its repetitions reach each of its pixels.
  std::vector<std::vector<Weighted>> of_pixel(tile * tile);
  for (const Vec2 point : pattern_points(sampling.pattern, sampling.samples * tile * tile, sampling.seed)) {
    const Vec2d p(static_cast<double>(point.x) * tile, static_cast<double>(point.y) * tile);
    const Vec2i first(static_cast<int>(std::floor(p.x - reach)), static_cast<int>(std::floor(p.y - reach)));
    for (int y = first.y; y <= first.y + 4; ++y)
      for (int x = first.x; x <= first.x + 4; ++x) {
        const Vec2d offset = p - Vec2d(x, y), from_centre = offset - 0.5;
        const double squared = dot(from_centre, from_centre);
        if (squared > reach * reach) continue;
        const auto at = static_cast<std::size_t>((y + tile) % tile * tile + (x + tile) % tile);
        of_pixel[at].push_back({offset, static_cast<float>(std::exp(-squared / (2 * sigma * sigma)))});
      }
  }
  Image image(width, height, rgb_channels());
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      Rgb sum;
      float weights = 0;
      for (const Weighted& w : of_pixel[static_cast<std::size_t>(y % tile * tile + x % tile)]) {
        sum += w.weight * scene(Vec2d(x, y) + w.offset);
        weights += w.weight;
      }
      if (weights > 0) image.set_rgb(x, y, sum / weights);
    }
  });
  return image;
}

double rms_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const double d = static_cast<double>(a.pixels()[i]) - static_cast<double>(b.pixels()[i]);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(a.pixels().size()));
}

}  // namespace lambert::lab
