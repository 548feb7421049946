#include "lambert/image/probe/linear_radiance.h"

#include "lambert/image/probe/parts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace lambert::probe {
namespace {

/// Of a texel and the brightest beside it: the largest ratio that is taken for smooth light's.
constexpr double steepest = 30;

struct Sample {
  Vec3d middle;
  Rgb value;
};

Rgb value_of(const Probe& probe, const Texel& t) {
  return probe.charts[static_cast<std::size_t>(t.chart)].rgb(t.x, t.y);
}

/// The images of a disk's texel, or of a direction, in the square's axes and diagonals; i from 1 to 7.
Texel image_of(Texel t, int i, int last) {
  if (i & 1) t.x = last - t.x;
  if (i & 2) t.y = last - t.y;
  return (i & 4) ? Texel{t.chart, last - t.y, last - t.x} : t;
}
Vec3d image_of(Vec3d d, int i) {
  if (i & 1) d.x = -d.x;
  if (i & 2) d.y = -d.y;
  return (i & 4) ? Vec3d(d.y, d.x, d.z) : d;
}

/// Images that lie no further than twice the texel's length: at a rim beyond which little is hidden they are all around
/// it.
void add_images(const Probe& probe, const Texel& texel, const Cell& cell, Vec3d middle, std::vector<Sample>& samples) {
  const DiskReach reach = disk_reach(probe.projection, cell);
  for (int i = 1; i < 8; ++i) {
    const Vec3d d = image_of(middle, i);
    if (length(d - middle) < 2 * (reach.theta1 - reach.theta0))
      samples.push_back({d, value_of(probe, image_of(texel, i, probe.width() - 1))});
  }
}

std::vector<Sample> samples_around(const Probe& probe, const Texel& texel, const Cell& cell, Vec3d middle) {
  std::vector<Sample> samples;
  for (const Vec2i step : {Vec2i(1, 0), Vec2i(-1, 0), Vec2i(0, 1), Vec2i(0, -1)}) {
    const auto n = neighbour(probe, texel, step);
    if (!n) continue;
    const CellIntegrals i = integrals(probe.projection, n->chart, texel_cell(probe, n->x, n->y));
    if (i.solid_angle > 0) samples.push_back({i.moment / i.solid_angle, value_of(probe, *n)});
  }
  if (has_disk(probe.projection)) add_images(probe, texel, cell, middle, samples);
  return samples;
}

/// The largest part of 1 by which `change` may be taken and stay between low <= 0 and high >= 0.
double allowed(double change, double low, double high) {
  if (change > high) return high / change;
  return change < low ? low / change : 1;
}

}  // namespace

LinearRadiance linear_radiance(const Probe& probe, const Texel& texel) {
  const Cell cell = texel_cell(probe, texel.x, texel.y);
  const CellIntegrals own = integrals(probe.projection, texel.chart, cell);
  LinearRadiance result{value_of(probe, texel)};
  if (!(own.solid_angle > 0)) return result;
  result.middle = own.moment / own.solid_angle;
  if (length(result.middle) < 0.5) return result;

  // (Σ w Δd Δdᵀ) g = Σ w Δd ΔL, w = 1 / Δd²; a little of the identity takes the shortest g where directions lack.
  glm::dmat3 matrix(1e-8);
  std::array<Vec3d, 3> right{};
  std::array<double, 3> low{}, high{}, brightest;  // less the texel's own value
  brightest.fill(-std::numeric_limits<double>::infinity());
  for (const Sample& s : samples_around(probe, texel, cell, result.middle)) {
    const Vec3d step = s.middle - result.middle;
    const double square = dot(step, step);
    if (!(square > 1e-12)) continue;
    matrix += glm::outerProduct(step, step) / square;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto change = static_cast<double>(s.value[static_cast<int>(k)] - result.mean[static_cast<int>(k)]);
      right[k] += step * (change / square);
      low[k] = std::min(low[k], change), high[k] = std::max(high[k], change);
      brightest[k] = std::max(brightest[k], change);
    }
  }
  const glm::dmat3 inverse = glm::inverse(matrix);
  std::vector<Vec3d> reached{normalize(result.middle)};
  for (const MapPoint& corner : corners(probe.projection, texel.chart, cell))
    if (const auto d = direction(probe.projection, corner)) reached.emplace_back(*d);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto mean = static_cast<double>(result.mean[static_cast<int>(k)]);
    const double top = mean + brightest[k];
    if (std::min(mean, top) >= 0 && std::max(mean, top) > steepest * std::min(mean, top)) continue;
    const Vec3d gradient = inverse * right[k];
    const double slack = 0.5 * (high[k] - low[k]);
    const double least = mean + low[k] >= 0 ? std::max(low[k] - slack, -mean) : low[k] - slack;
    double part = 1;
    for (const Vec3d& d : reached)
      part = std::min(part, allowed(dot(gradient, d - result.middle), least, high[k] + slack));
    result.gradient[k] = part * gradient;
  }
  return result;
}

std::array<Vec3d, 3> radiance_moments(const Probe& probe, const Texel& texel) {
  const Cell cell = texel_cell(probe, texel.x, texel.y);
  const CellIntegrals own = integrals(probe.projection, texel.chart, cell);
  std::array<Vec3d, 3> moments{};
  const auto add = [&](Rgb colour, Vec3d moment) {
    for (std::size_t k = 0; k < 3; ++k) moments[k] += static_cast<double>(colour[static_cast<int>(k)]) * moment;
  };
  if (half_angle(probe.projection, texel.chart, cell, own) <= widest_part) {
    add(value_of(probe, texel), own.moment);
    return moments;
  }
  const LinearRadiance radiance = linear_radiance(probe, texel);
  for_each_part(probe.projection, texel.chart, cell,
                [&](const Cell&, const CellIntegrals& i) { add(radiance(i.moment / i.solid_angle), i.moment); });
  return moments;
}

void add_touched(const Probe& probe, const Texel& texel, std::vector<Texel>& touched) {
  touched.push_back(texel);
  // Corners too: across the edges of a cube neighbours need not be mutual.
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      if (const auto n = neighbour(probe, texel, {x, y})) touched.push_back(*n);
  if (!has_disk(probe.projection)) return;
  for (int i = 1; i < 8; ++i) touched.push_back(image_of(texel, i, probe.width() - 1));
}

}  // namespace lambert::probe
