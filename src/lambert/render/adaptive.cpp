#include "lambert/render/adaptive.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lambert {
namespace {

constexpr int neighbourhood = 2;  // pixels to each side
constexpr double dark_luminance = 0.05;

struct Pilot {
  double variance = 0;  // of one sample
  double luminance = 0;
};

Pilot average_pilot(const Film& film, Vec2i pixel) {
  const PixelRect& crop = film.crop();
  Pilot sum;
  int count = 0;
  for (int y = std::max(crop.min.y, pixel.y - neighbourhood); y <= std::min(crop.max.y - 1, pixel.y + neighbourhood);
       ++y)
    for (int x = std::max(crop.min.x, pixel.x - neighbourhood); x <= std::min(crop.max.x - 1, pixel.x + neighbourhood);
         ++x) {
      sum.variance += film.variance_of_mean({x, y}) * film.sample_count({x, y});
      sum.luminance += static_cast<double>(luminance(film.mean({x, y})));
      ++count;
    }
  return {sum.variance / count, sum.luminance / count};
}

}  // namespace

std::uint64_t SampleMap::total() const { return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}); }

SampleMap plan_samples(const Film& pilot, double target_error, std::uint32_t at_least, std::uint32_t at_most) {
  SampleMap map(pilot.crop(), at_most);
  for (int y = pilot.crop().min.y; y < pilot.crop().max.y; ++y)
    for (int x = pilot.crop().min.x; x < pilot.crop().max.x; ++x) {
      const Pilot p = average_pilot(pilot, {x, y});
      // Var(average) = (v/n + v/n) / 4 <= e²  =>  n >= v / (2 e²)
      const double allowed = target_error * std::max(p.luminance, dark_luminance);
      const double wanted = std::ceil(p.variance / (2 * allowed * allowed));
      const double upper = static_cast<double>(at_most);
      map.set({x, y}, wanted < upper ? std::max(at_least, static_cast<std::uint32_t>(wanted)) : at_most);
    }
  return map;
}

}  // namespace lambert
