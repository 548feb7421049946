#include "lambert/image/probe/missing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace lambert::probe {
namespace {

bool is_finite(const Image& image, Vec2i p) {
  for (std::size_t c = 0; c < image.channel_count(); ++c)
    if (!std::isfinite(image.at(p.x, p.y, c))) return false;
  return true;
}

}  // namespace

std::size_t fill_missing(Image& image) {
  std::vector<Vec2i> missing;
  const std::size_t channels = image.channel_count();
  for (int y = 0; y < image.height(); ++y) {
    const auto row = image.row(y);
    // 0 v is 0 for finite numbers only.
    float zero = 0;
    for (const float v : row) zero += 0 * v;
    if (zero == 0) continue;
    for (int x = 0; x < image.width(); ++x)
      if (!is_finite(image, {x, y})) missing.push_back({x, y});
  }
  const std::size_t count = missing.size();
  while (!missing.empty()) {
    std::vector<Vec2i> later;
    std::vector<std::pair<Vec2i, std::vector<float>>> filled;
    for (const Vec2i p : missing) {
      std::vector<float> sum(channels, 0);
      int neighbours = 0;
      for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, image.height() - 1); ++y)
        for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, image.width() - 1); ++x) {
          if (!is_finite(image, {x, y})) continue;
          ++neighbours;
          for (std::size_t c = 0; c < channels; ++c) sum[c] += image.at(x, y, c);
        }
      if (neighbours == 0) {
        later.push_back(p);
        continue;
      }
      for (float& v : sum) v /= static_cast<float>(neighbours);
      filled.emplace_back(p, std::move(sum));
    }
    if (filled.empty())  // nothing is finite
      for (const Vec2i p : std::exchange(later, {})) filled.emplace_back(p, std::vector<float>(channels, 0));
    for (const auto& [p, values] : filled)
      for (std::size_t c = 0; c < channels; ++c) image.at(p.x, p.y, c) = std::isfinite(values[c]) ? values[c] : 0;
    missing = std::move(later);
  }
  return count;
}

}  // namespace lambert::probe
