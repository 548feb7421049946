#include "lambert/image/filter/footprint.h"

#include <algorithm>
#include <cmath>

namespace lambert {

double largest_edge(const Footprint& f) {
  const auto length_of = [](Vec2 v) { return std::hypot(static_cast<double>(v.x), static_cast<double>(v.y)); };
  return std::max(length_of(f.dx), length_of(f.dy));
}

double largest_edge(const std::array<Vec2d, 4>& corners) {
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) largest = std::max(largest, glm::length(corners[(i + 1) % 4] - corners[i]));
  return largest;
}

LevelChoice level_for(double texels, int level_count) {
  if (!(texels > 1)) return {};
  const double k = std::log2(texels);
  if (!(k < level_count - 1)) return {level_count - 1, 0};
  return {static_cast<int>(k), k - std::floor(k)};
}

}  // namespace lambert
