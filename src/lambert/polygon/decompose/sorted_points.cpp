#include "lambert/polygon/decompose/sorted_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lambert::polygon {
namespace {

struct Entry {
  double x, y;
  std::uint32_t index;
  bool operator<(const Entry& b) const {
    if (x != b.x) return x < b.x;
    return y != b.y ? y < b.y : index < b.index;
  }
};

}  // namespace

std::vector<std::uint32_t> sorted_left_to_right(std::span<const Vec2d> points) {
  std::vector<std::uint32_t> order(points.size());
  if (points.empty()) return order;
  double low = points[0].x, high = low;
  for (const Vec2d p : points) low = std::min(low, p.x), high = std::max(high, p.x);
  const auto last = static_cast<double>(points.size() - 1);
  const double scale = last / (high - low);
  // Each step rounds monotonically, so that a bucket never lies left of a smaller x.
  const auto bucket = [&](double x) { return static_cast<std::size_t>(std::min((x - low) * scale, last)); };
  const bool spread = high > low && std::isfinite(scale) && std::isfinite(high - low);

  std::vector<std::uint32_t> start(points.size() + 1, 0);
  std::vector<Entry> entries(points.size());
  if (spread) {
    for (const Vec2d p : points) ++start[bucket(p.x) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      entries[next[bucket(points[i].x)]++] = {points[i].x, points[i].y, static_cast<std::uint32_t>(i)};
  } else {
    for (std::size_t i = 0; i < points.size(); ++i)
      entries[i] = {points[i].x, points[i].y, static_cast<std::uint32_t>(i)};
    start[1] = static_cast<std::uint32_t>(points.size());
    std::fill(start.begin() + 1, start.end(), start[1]);
  }
  for (std::size_t b = 0; b < points.size(); ++b)
    if (start[b + 1] - start[b] > 1) std::sort(entries.begin() + start[b], entries.begin() + start[b + 1]);
  for (std::size_t i = 0; i < entries.size(); ++i) order[i] = entries[i].index;
  return order;
}

}  // namespace lambert::polygon
