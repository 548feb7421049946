#include "lambert/polygon/pick.h"

#include "lambert/polygon/segment.h"

#include <algorithm>

namespace lambert::polygon {

GravityField field_of_pixels(double radius_pixels, double width_pixels, const Box2& window, const Box2& viewport) {
  const Vec2d per_pixel = window.size() / viewport.size();
  const double scale = std::max(per_pixel.x, per_pixel.y);
  return {radius_pixels * scale, width_pixels * scale};
}

bool is_picked(const GravityField& field, Vec2d a, Vec2d b, Vec2d p) {
  if (safe_length(p - a) < field.radius || safe_length(p - b) < field.radius) return true;
  const auto foot = foot_of_perpendicular(a, b, p);
  return foot && foot->on_segment() && foot->distance <= 0.5 * field.width;
}

std::optional<std::size_t> picked_edge(const GravityField& field, const Ring& ring, Vec2d p) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d a = ring[i], b = ring[next_index(i, ring.size())];
    if (!is_picked(field, a, b, p)) continue;
    const double distance = distance_to_segment(a, b, p);
    if (distance < least) least = distance, nearest = i;
  }
  return nearest;
}

}  // namespace lambert::polygon
