#include "lambert/image/denoise/nlm.h"

#include "lambert/base/parallel.h"
#include "lambert/image/denoise/guide_filter.h"
#include "lambert/image/denoise/patch_distance.h"

#include <algorithm>
#include <memory>

namespace lambert::denoise {
namespace {

bool is_noisy(std::span<const Plane> variances, Tile tile) {
  for (const Plane& plane : variances)
    for (int y = tile.y; y < std::min(tile.y + tile_size, plane.height()); ++y)
      for (int x = tile.x; x < std::min(tile.x + tile_size, plane.width()); ++x)
        if (plane.at(x, y) > 0) return true;
  return false;
}

}  // namespace

std::vector<Plane> nl_means(std::span<const Plane> planes, std::span<const Plane> guides,
                            std::span<const Plane> variances, const NlmSettings& settings,
                            const FractionSink& progress) {
  const int width = planes[0].width(), height = planes[0].height(), radius = settings.window_radius;
  const PatchGuide guide(guides, variances, radius, settings.patch_radius);
  std::vector<PaddedPlane> padded;
  for (const Plane& plane : planes) padded.emplace_back(plane, radius + tile_size);
  std::vector<Plane> result(planes.begin(), planes.end());
  const std::vector<Tile> tiles = tiles_of(width, height);
  parallel_for(tiles.size(), progress, [&](std::size_t i) {
    const Tile tile = tiles[i];
    if (!is_noisy(variances, tile)) return;
    const auto weights =
        std::make_unique<TileWeights>(guide, tile, 1, settings.patch_radius, 1 / (settings.k * settings.k));
    constexpr std::size_t area = tile_size * tile_size;
    std::vector<float> sums(area * planes.size()), norm(area);
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const float* __restrict w = weights->at(dx, dy);
        for (std::size_t k = 0; k < area; ++k) norm[k] += w[k];
        for (std::size_t p = 0; p < planes.size(); ++p)
          for (int j = 0; j < tile_size; ++j) {
            const float* __restrict from = padded[p].row(tile.y + j + dy) + tile.x + dx;
            float* __restrict to = sums.data() + p * area + static_cast<std::size_t>(j) * tile_size;
            const float* __restrict row = w + j * tile_size;
            for (int x = 0; x < tile_size; ++x) to[x] += row[x] * from[x];
          }
      }
    for (std::size_t p = 0; p < planes.size(); ++p)
      for (int j = 0; j < std::min(tile_size, height - tile.y); ++j)
        for (int x = 0; x < std::min(tile_size, width - tile.x); ++x) {
          const auto k = static_cast<std::size_t>(j * tile_size + x);
          // The pixel's own weight is 1.
          result[p].at(tile.x + x, tile.y + j) = sums[p * area + k] / norm[k];
        }
  });
  return result;
}

Colour denoise_nlm(const NoisyImage& image, const NlmSettings& settings, const FractionSink& progress) {
  Colour variance = image.variance;  // of one half
  for (Plane& plane : variance)
    for (float& v : plane.values()) v *= 2;
  Colour result = black(image.width, image.height);
  for (std::size_t half = 0; half < 2; ++half) {
    const std::vector<Plane> filtered =
        nl_means(image.halves[half], image.halves[1 - half], variance, settings,
                 part_of(progress, 0.5 * static_cast<double>(half), 0.5 * static_cast<double>(half + 1)));
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < filtered[c].values().size(); ++i)
        result[c].values()[i] += 0.5f * filtered[c].values()[i];
  }
  add_filtered_emission(result, image);
  return result;
}

}  // namespace lambert::denoise
