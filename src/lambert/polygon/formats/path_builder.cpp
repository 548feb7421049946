#include "lambert/polygon/formats/path_builder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lambert::polygon {
namespace {

template <class T>
void move_to_end(std::vector<T>& all, std::vector<T>& more) {
  if (all.empty()) {
    all = std::move(more);
  } else {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }
}

}  // namespace

Path make_path(std::span<const Vec3d> positions) {
  Path path;
  path.points.reserve(positions.size());
  for (const Vec3d& p : positions) path.points.push_back({p.x, p.y});
  if (std::none_of(positions.begin(), positions.end(), [](const Vec3d& p) { return std::isnan(p.z); })) {
    path.heights.reserve(positions.size());
    for (const Vec3d& p : positions) path.heights.push_back(p.z);
  }
  return path;
}

Path make_closed_ring(std::span<const Vec3d> positions) {
  if (positions.size() < 2) return make_path(positions);
  const Vec3d &first = positions.front(), &last = positions.back();
  const bool same_height = first.z == last.z || std::isnan(first.z) || std::isnan(last.z);
  const bool closed = first.x == last.x && first.y == last.y && same_height;
  Path ring = make_path(closed ? positions.first(positions.size() - 1) : positions);
  ring.closed = closed;
  return ring;
}

void append(Path& path, Path&& more) {
  if (more.points.empty()) return;
  const bool some_lack = more.heights.empty() || (path.heights.empty() && !path.points.empty());
  move_to_end(path.points, more.points);
  if (some_lack) {
    path.heights.clear();
  } else {
    move_to_end(path.heights, more.heights);
  }
}

void append(Feature& feature, Feature&& more) {
  append(feature.points, std::move(more.points));
  move_to_end(feature.lines, more.lines);
  move_to_end(feature.polygons, more.polygons);
}

}  // namespace lambert::polygon
