#include "lambert/draw/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lambert::draw {

using namespace polygon;

namespace {

/// Calls piece(a, b) for what is drawn of the segments: all of it, or every second dash along the whole stroke.
template <class F>
void for_each_piece(const Stroke& stroke, F&& piece) {
  const std::size_t n = stroke.points.size(), segments = stroke.closed ? n : n - 1;
  double travelled = 0;
  for (std::size_t i = 0; i < segments; ++i) {
    const Vec2d a = stroke.points[i], b = stroke.points[next_index(i, n)];
    const double length = glm::length(b - a);
    if (stroke.dash <= 0 || !(length < 1e5)) {
      piece(a, b);
      continue;
    }
    const double period = 2 * stroke.dash;
    for (double start = -std::fmod(travelled, period); start < length; start += period) {
      const double from = std::max(start, 0.0), to = std::min(start + stroke.dash, length);
      if (from < to) piece(a + (b - a) * (from / length), a + (b - a) * (to / length));
    }
    travelled += length;
  }
}

}  // namespace

Ring circle(Vec2d centre, double radius, double pixel) {
  // A chord of n leaves radius (1 - cos(pi / n)) of the arc.
  const double sagitta = std::clamp(0.1 * pixel / std::max(radius, 1e-9), 1e-4, 0.3);
  const int corners = std::max(6, static_cast<int>(std::ceil(std::numbers::pi / std::acos(1 - sagitta))));
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(centre + radius * Vec2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

Rings outline(const Stroke& stroke, double pixel) {
  Rings rings;
  if (stroke.points.empty()) return rings;
  const double half = 0.5 * stroke.width;
  for_each_piece(stroke, [&](Vec2d a, Vec2d b) {
    const double length = glm::length(b - a);
    rings.push_back(circle(a, half, pixel));
    rings.push_back(circle(b, half, pixel));
    if (!(length > 0)) return;
    const Vec2d along = (b - a) * (half / length), left(-along.y, along.x);
    rings.push_back({a - left, b - left, b + left, a + left});
  });
  return rings;
}

}  // namespace lambert::draw
