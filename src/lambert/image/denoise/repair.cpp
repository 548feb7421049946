#include "lambert/image/denoise/repair.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::denoise {
namespace {

bool is_usable(float v) { return std::abs(v) < 1e15f; }  // false for NaN

float mean_around(const Plane& plane, int x, int y) {
  for (int radius = 1; radius <= 64; radius *= 2) {
    double sum = 0;
    int count = 0;
    for (int t = std::max(y - radius, 0); t <= std::min(y + radius, plane.height() - 1); ++t)
      for (int s = std::max(x - radius, 0); s <= std::min(x + radius, plane.width() - 1); ++s)
        if (const float v = plane.at(s, t); is_usable(v)) sum += static_cast<double>(v), ++count;
    if (count > 0) return static_cast<float>(sum / count);
  }
  return 0;
}

}  // namespace

void repair(Plane& plane) {
  if (std::all_of(plane.values().begin(), plane.values().end(), is_usable)) return;
  Plane whole = plane;
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x)
      if (!is_usable(plane.at(x, y))) whole.at(x, y) = mean_around(plane, x, y);
  plane = std::move(whole);
}

}  // namespace lambert::denoise
