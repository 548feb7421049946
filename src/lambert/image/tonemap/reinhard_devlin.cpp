#include "lambert/image/tonemap/reinhard_devlin.h"

#include "lambert/image/tonemap/fast_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::tone {

float ReinhardDevlin::contrast_of(const LuminanceStatistics& s) {
  const float range = std::log(s.largest) - std::log(s.smallest);
  const float key = range > 0 ? (std::log(s.largest) - std::log(s.log_average)) / range : 0.0f;
  return 0.3f + 0.7f * std::pow(std::clamp(key, 0.0f, 1.0f), 1.4f);
}

void ReinhardDevlin::map(RgbPlanes& planes, const LuminanceMap& map) const {
  const LuminanceStatistics& s = map.statistics;
  const float m = contrast > 0 ? contrast : contrast_of(s), f = std::exp(-std::clamp(intensity, -40.0f, 40.0f));
  const int height = map.luminance.height;
  const std::size_t width = static_cast<std::size_t>(map.luminance.width);
  constexpr float tiny = std::numeric_limits<float>::min(), huge = std::numeric_limits<float>::max();
  std::vector<float> least(static_cast<std::size_t>(row_blocks(height)), huge), most(least.size(), 0.0f);
  Plane* const channels[] = {&planes.r, &planes.g, &planes.b};
  for_row_blocks(height, [&](std::size_t block, int first, int last) {
    for (int c = 0; c < 3; ++c) {
      const float global = chromatic * s.average_colour[c] + (1 - chromatic) * s.average;
      for (int y = first; y < last; ++y) {
        const float* const luminance = map.luminance.row(y).data();
        const auto row = channels[c]->row(y);
        float* const value = row.data();
        for (std::size_t x = 0; x < width; ++x) {
          const float local = chromatic * value[x] + (1 - chromatic) * luminance[x];
          const float adaptation = light * local + (1 - light) * global;
          value[x] = value[x] / (value[x] + fast_pow(at_least(f * adaptation, tiny), m));
        }
        const auto [low, high] = std::minmax_element(row.begin(), row.end());
        least[block] = std::min(least[block], *low), most[block] = std::max(most[block], *high);
      }
    }
  });
  const float low = *std::min_element(least.begin(), least.end()), high = *std::max_element(most.begin(), most.end());
  // A map of one value has no range to stretch.
  const float offset = high > low ? low : 0, scale = high > low ? 1 / (high - low) : 1;
  for (Plane* channel : channels)
    for_rows(height, [&](int y) {
      for (float& v : channel->row(y)) v = (v - offset) * scale;
    });
}

}  // namespace lambert::tone
