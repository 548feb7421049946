#include "lambert/image/probe/parts.h"

#include "lambert/image/probe/disk.h"

#include <algorithm>
#include <cmath>

namespace lambert::probe {
namespace {

double diagonal(const Cell& c) { return 2 * std::hypot(c.u1 - c.u0, c.v1 - c.v0); }

}  // namespace

bool has_disk(const AnyProjection& p) {
  return std::holds_alternative<MirrorBall>(p) || std::holds_alternative<Fisheye>(p);
}

bool at_rim(const AnyProjection& projection, const Cell& c) {
  return has_disk(projection) && diagonal(c) < 0.03 && disk_reach(projection, c).nearest > 0.9;
}

std::array<Cell, 4> parts(const AnyProjection& projection, const Cell& c) {
  if (at_rim(projection, c)) {
    const DiskReach r = disk_reach(projection, c);
    const double step = 0.25 * (r.theta1 - r.theta0);
    std::array<Cell, 4> rings{c, c, c, c};
    for (std::size_t i = 0; i < 4; ++i) {
      rings[i].theta0 = r.theta0 + step * static_cast<double>(i);
      rings[i].theta1 = r.theta0 + step * static_cast<double>(i + 1);
    }
    return rings;
  }
  const double u = 0.5 * (c.u0 + c.u1), v = 0.5 * (c.v0 + c.v1);
  return {Cell{c.u0, u, c.v0, v}, Cell{u, c.u1, c.v0, v}, Cell{c.u0, u, v, c.v1}, Cell{u, c.u1, v, c.v1}};
}

std::array<MapPoint, 4> corners(const AnyProjection& projection, int chart, const Cell& c) {
  std::array<MapPoint, 4> points;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 uv(Vec2d((i & 1) ? c.u1 : c.u0, (i & 2) ? c.v1 : c.v0)), p = disk_point(uv);
    const float r = length(p);
    const bool out = has_disk(projection) && r > 0.999999f;
    points[i] = {chart, out ? disk_uv(p * (0.999999f / r)) : uv};
  }
  return points;
}

float angle_between(Vec3 a, Vec3 b) { return 2 * std::asin(std::min(1.0f, 0.5f * length(a - b))); }

float half_angle(const AnyProjection& projection, int chart, const Cell& cell, const CellIntegrals& sums) {
  const double size = length(sums.moment);
  if (!(sums.solid_angle > 0)) return 0;  // out of the disk
  if (!(size > 0.99 * sums.solid_angle)) return pi;
  if (at_rim(projection, cell)) {
    const DiskReach r = disk_reach(projection, cell);
    return static_cast<float>(std::hypot(0.5 * (r.theta1 - r.theta0), 0.6 * diagonal(cell)));
  }
  const Vec3 axis(sums.moment / size);
  float angle = 0;
  for (const MapPoint& corner : corners(projection, chart, cell))
    if (const auto d = direction(projection, corner)) angle = std::max(angle, angle_between(*d, axis));
  return angle;
}

}  // namespace lambert::probe
