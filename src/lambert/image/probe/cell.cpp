#include "lambert/image/probe/cell.h"

#include "lambert/image/probe/disk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lambert::probe {
namespace {

constexpr double pi_d = std::numbers::pi;

CellIntegrals by_gauss(const AnyProjection& projection, int chart, const Cell& cell) {
  const double gauss = 0.5 / std::sqrt(3.0), width = cell.u1 - cell.u0, height = cell.v1 - cell.v0;
  CellIntegrals sum;
  for (int i = 0; i < 4; ++i) {
    const Vec2d uv(cell.u0 + width * (0.5 + ((i & 1) ? gauss : -gauss)),
                   cell.v0 + height * (0.5 + ((i & 2) ? gauss : -gauss)));
    const MapPoint at{chart, Vec2(uv)};
    const auto d = direction(projection, at);
    if (!d) continue;
    const double w = 0.25 * width * height * static_cast<double>(density(projection, at));
    sum.solid_angle += w, sum.moment += w * Vec3d(*d);
  }
  return sum;
}

/// ∫∫ (1 + a² + b²)^-3/2 da db from (0, 0) to (a, b).
double cube_corner(double a, double b) { return std::atan2(a * b, std::sqrt(a * a + b * b + 1)); }

double cube_solid_angle(const Cell& c) {
  const double a0 = 2 * c.u0 - 1, a1 = 2 * c.u1 - 1, b0 = 2 * c.v0 - 1, b1 = 2 * c.v1 - 1;
  return cube_corner(a1, b1) - cube_corner(a0, b1) - cube_corner(a1, b0) + cube_corner(a0, b0);
}

CellIntegrals scaled_to(CellIntegrals i, double solid_angle) {
  return {solid_angle, i.solid_angle > 0 ? i.moment * (solid_angle / i.solid_angle) : Vec3d(0)};
}

/// A part of a cell in one quadrant of the disk, its coordinates as distances from the axes.
struct Quadrant {
  double x0, x1, y0, y1;  // 0 <= x0 < x1, 0 <= y0 < y1
};

/// Gauss' rule of six points over s of [0, 1], its places as (1 - cos πs) / 2.
struct RingRule {
  std::array<double, 6> place, weight;
};
const RingRule& ring_rule() {
  static const RingRule rule = [] {
    constexpr std::array<double, 3> nodes{0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
    constexpr std::array<double, 3> weights{0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
    RingRule r;
    for (std::size_t i = 0; i < 6; ++i) {
      const double s = 0.5 * (1 + (i % 2 == 0 ? nodes[i / 2] : -nodes[i / 2]));
      r.place[i] = 0.5 * (1 - std::cos(pi_d * s));
      r.weight[i] = 0.25 * pi_d * weights[i / 2] * std::sin(pi_d * s);
    }
    return r;
  }();
  return rule;
}

/// Over rings of radius r(θ) from θ0 to θ1, between which no corner lies. The arc's length has square roots at the
/// ends, where rings touch sides: θ = θ0 + (θ1 - θ0) (1 - cos πs) / 2 undoes them.
template <class Disk>
CellIntegrals rings(const Disk& disk, const Quadrant& q, double theta0, double theta1) {
  const RingRule& rule = ring_rule();
  CellIntegrals sum;
  for (std::size_t i = 0; i < 6; ++i) {
    const double theta = theta0 + (theta1 - theta0) * rule.place[i];
    const auto r = static_cast<double>(disk.radius(static_cast<float>(theta)));
    const auto part = [&](double a) { return std::min(1.0, a / r); };
    const auto other = [](double a) { return std::sqrt(1 - a * a); };
    // The arc's ends, as points on a circle of radius 1.
    const double sin_from = std::max(part(q.y0), other(part(q.x1))), cos_to = std::max(part(q.x0), other(part(q.y1)));
    const double cos_from = other(sin_from), sin_to = other(cos_to);
    if (!(sin_to > sin_from)) continue;
    const double arc = std::atan2(sin_to * cos_from - cos_to * sin_from, cos_to * cos_from + sin_to * sin_from);
    const double sin_theta = std::sin(theta);
    const double ring = rule.weight[i] * (theta1 - theta0) * sin_theta;
    sum.solid_angle += ring * arc;
    sum.moment += ring * Vec3d(sin_theta * (sin_to - sin_from), sin_theta * (cos_from - cos_to),
                               Disk::axis * std::cos(theta) * arc);
  }
  return sum;
}

template <class Disk>
CellIntegrals by_rings(const Disk& disk, const Quadrant& q, const Cell& limits) {
  std::array<double, 4> radii{std::hypot(q.x0, q.y0), std::hypot(q.x1, q.y0), std::hypot(q.x0, q.y1),
                              std::hypot(q.x1, q.y1)};
  std::sort(radii.begin(), radii.end());
  CellIntegrals sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto theta = [&](double r) { return static_cast<double>(disk.angle(static_cast<float>(std::min(r, 1.0)))); };
    const double low = std::max(theta(radii[i]), limits.theta0), high = std::min(theta(radii[i + 1]), limits.theta1);
    if (!(high > low)) continue;
    const CellIntegrals part = rings(disk, q, low, high);
    sum.solid_angle += part.solid_angle, sum.moment += part.moment;
  }
  return sum;
}

template <class Disk>
CellIntegrals of_disk(const Disk& disk, const Cell& cell) {
  const double x0 = 2 * cell.u0 - 1, x1 = 2 * cell.u1 - 1, y0 = 1 - 2 * cell.v1, y1 = 1 - 2 * cell.v0;
  const double farthest = std::hypot(std::max(-x0, x1), std::max(-y0, y1));
  const bool whole = cell.theta0 == Cell{}.theta0 && cell.theta1 == Cell{}.theta1;
  if (whole && farthest + 2 * std::hypot(x1 - x0, y1 - y0) < 1) return by_gauss(disk, 0, cell);
  CellIntegrals sum;
  for (const double sx : {1.0, -1.0})
    for (const double sy : {1.0, -1.0}) {
      const Quadrant q{std::max(0.0, sx > 0 ? x0 : -x1), sx > 0 ? x1 : -x0, std::max(0.0, sy > 0 ? y0 : -y1),
                       sy > 0 ? y1 : -y0};
      if (!(q.x1 > q.x0 && q.y1 > q.y0)) continue;
      const CellIntegrals part = by_rings(disk, q, cell);
      sum.solid_angle += part.solid_angle, sum.moment += part.moment * Vec3d(sx, sy, 1);
    }
  return sum;
}

template <class Disk>
DiskReach reach_of(const Disk& disk, const Cell& cell) {
  const double x = std::clamp(0.5, cell.u0, cell.u1) - 0.5, y = std::clamp(0.5, cell.v0, cell.v1) - 0.5;
  const double nearest = 2 * std::hypot(x, y);
  const double farthest =
      2 * std::hypot(std::max(0.5 - cell.u0, cell.u1 - 0.5), std::max(0.5 - cell.v0, cell.v1 - 0.5));
  const auto theta = [&](double r) { return static_cast<double>(disk.angle(static_cast<float>(std::min(r, 1.0)))); };
  return {nearest, std::max(theta(nearest), cell.theta0), std::min(theta(farthest), cell.theta1)};
}

}  // namespace

/// ∫∫ (sin θ sin φ, cos θ, -sin θ cos φ) sin θ dφ dθ; sums as middles and halves, which do not cancel:
/// ∫ sin² θ = (Δ - cos 2θ sin Δ) / 2, ∫ sin θ cos θ = sin 2θ sin Δ / 2 about the middle θ.
LatLongRow lat_long_row(const Cell& cell) {
  const double theta = 0.5 * pi_d * (cell.v0 + cell.v1), delta = pi_d * (cell.v1 - cell.v0);
  return {2 * std::sin(theta) * std::sin(0.5 * delta), 0.5 * (delta - std::cos(2 * theta) * std::sin(delta)),
          0.5 * std::sin(2 * theta) * std::sin(delta)};
}

LatLongColumn lat_long_column(const LatLong& map, const Cell& cell) {
  const double phi = 2 * pi_d * (0.5 * (cell.u0 + cell.u1) - 0.5), width = 2 * pi_d * (cell.u1 - cell.u0);
  const double chord = (map.centre_is_plus_z ? -2 : 2) * std::sin(0.5 * width);
  return {width, chord * std::sin(phi), -chord * std::cos(phi)};
}

DiskReach disk_reach(const AnyProjection& projection, const Cell& cell) {
  if (const auto* ball = std::get_if<MirrorBall>(&projection)) return reach_of(*ball, cell);
  return reach_of(std::get<Fisheye>(projection), cell);
}

CellIntegrals integrals(const AnyProjection& projection, int chart, const Cell& cell) {
  if (const auto* map = std::get_if<LatLong>(&projection))
    return integrals(lat_long_row(cell), lat_long_column(*map, cell));
  if (const auto* ball = std::get_if<MirrorBall>(&projection)) return of_disk(*ball, cell);
  if (const auto* fisheye = std::get_if<Fisheye>(&projection)) return of_disk(*fisheye, cell);
  const CellIntegrals sum = by_gauss(projection, chart, cell);
  if (std::holds_alternative<Cube>(projection)) return scaled_to(sum, cube_solid_angle(cell));
  return sum;
}

}  // namespace lambert::probe
