/// The largest error of irradiance, in parts of π, over normals all around and peaks of light at the rims and between,
/// against brute force; layouts at several sizes, with texels that are means over what they show, and with samples at
/// their middles (at the nearest place of a disk where that lies outside). Prints TSV.

#include "lambert/image/probe/irradiance.h"
#include "lambert/base/hash.h"
#include "lambert/image/probe/disk.h"
#include "lambert/image/probe/parts.h"
#include "lambert/image/probe/spherical_harmonics.h"
#include "lambert/image/probe/texels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace lambert;
using namespace lambert::probe;

const Vec3 slope(0.3f, -0.2f, 0.5f);

/// Linear, a lobe, and a sharp edge.
Rgb environment(Vec3 d, Vec3 up) {
  const float c = dot(d, up);
  return {1 + dot(slope, d), c > 0 ? c * c * c : 0, c > 0 ? 1.0f : 0.0f};
}

Rgb mean_of(const Probe& probe, const MapPoint& first, const MapPoint& last, int n, Vec3 up) {
  Rgb sum;
  float weight = 0;
  for (int k = 0; k < n * n; ++k) {
    const Vec2 place = (Vec2(k % n, k / n) + 0.5f) / static_cast<float>(n);
    const MapPoint at{first.chart, glm::mix(first.uv, last.uv, place)};
    if (const auto d = direction(probe.projection, at)) {
      const float w = density(probe.projection, at);
      sum += w * environment(*d, up), weight += w;
    }
  }
  return weight > 0 ? sum / weight : Rgb();
}

/// What the middle shows, or the place of the disk that is nearest to it.
Rgb sample_of(const Probe& probe, MapPoint at, Vec3 up) {
  if (!direction(probe.projection, at)) at.uv = disk_uv(normalize(disk_point(at.uv)) * 0.999999f);
  return environment(*direction(probe.projection, at), up);
}

Probe map_of(const AnyProjection& projection, int rows, bool means, Vec3 up) {
  Probe probe{projection, TexelRule::cells, {}};
  const Vec2i size = chart_size(projection, rows);
  for (int chart = 0; chart < chart_count(projection); ++chart) {
    Image& image = probe.charts.emplace_back(size.x, size.y, rgb_channels());
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const Cell cell = texel_cell(probe, x, y);
        const Vec2 low(Vec2d(cell.u0, cell.v0)), high(Vec2d(cell.u1, cell.v1));
        const bool rim = has_disk(projection) && length(glm::abs(disk_point(0.5f * (low + high)))) > 0.9f;
        image.set_rgb(x, y,
                      means ? mean_of(probe, {chart, low}, {chart, high}, rim ? 32 : 6, up)
                            : sample_of(probe, {chart, 0.5f * (low + high)}, up));
      }
  }
  return probe;
}

/// ∫ max(0, c)³ max(0, n·d) dω about the angle between both.
double lobe_irradiance(double cosine) {
  constexpr int rings = 400, sectors = 800;
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double z = (i + 0.5) / rings, ring = std::sqrt(1 - z * z);
    for (int k = 0; k < sectors; ++k) {
      const double phi = 2 * std::numbers::pi * (k + 0.5) / sectors;
      sum += z * z * z * std::max(0.0, z * cosine + ring * std::cos(phi) * sine);
    }
  }
  return sum * 2 * std::numbers::pi / sectors / rings;
}

std::vector<Vec3> normals() {
  std::vector<Vec3> all{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::uint64_t i = 0; i < 60; ++i) {
    const float z = 2 * hash_to_float(hash_values(i, std::uint64_t{1})) - 1;
    const float phi = 2 * pi * hash_to_float(hash_values(i, std::uint64_t{2})), ring = std::sqrt(1 - z * z);
    all.emplace_back(ring * std::cos(phi), ring * std::sin(phi), z);
  }
  return all;
}

struct Errors {
  double linear = 0, lobe = 0, edge = 0, linear_by_sh = 0;
};

Errors errors(const AnyProjection& projection, int rows, bool means) {
  Errors worst;
  const auto at_least = [](double& worst_yet, float got, double want) {
    worst_yet = std::max(worst_yet, std::abs(static_cast<double>(got) - want) / std::numbers::pi);
  };
  for (const Vec3 towards : {Vec3(1, 2, -0.5f), Vec3(0, 0, 1), Vec3(0.2f, 0.1f, -1)}) {
    const Vec3 up = normalize(towards);
    const Probe map = map_of(projection, rows, means, up);
    const Irradiance e(map);
    const auto sh = sh_irradiance(sh_project(map, 2));
    for (const Vec3 n : normals()) {
      const double cosine = static_cast<double>(dot(n, up));
      const double linear = std::numbers::pi + 2 * std::numbers::pi / 3 * static_cast<double>(dot(slope, n));
      const Rgb got = e(n);
      at_least(worst.linear, got.r, linear);
      at_least(worst.lobe, got.g, lobe_irradiance(cosine));
      at_least(worst.edge, got.b, std::numbers::pi * (1 + cosine) / 2);
      at_least(worst.linear_by_sh, sh_radiance(sh, n).r, linear);
    }
  }
  return worst;
}

}  // namespace

int main() {
  const std::pair<const char*, AnyProjection> layouts[] = {
      {"lat-long", LatLong{}},     {"cube", Cube{}},           {"octahedral", Octahedral{}},
      {"equal-area", EqualArea{}}, {"angular", angular_map()}, {"mirror-ball", MirrorBall{}},
  };
  std::printf("layout\trows\ttexels\tlinear\tlobe\tedge\tharmonics\n");
  for (const auto& [name, projection] : layouts)
    for (const bool means : {true, false})
      for (const int rows : {16, 32, 64, 128, 256}) {
        const Errors e = errors(projection, rows, means);
        std::printf("%s\t%d\t%s\t%.1e\t%.1e\t%.1e\t%.1e\n", name, rows, means ? "means" : "samples", e.linear, e.lobe,
                    e.edge, e.linear_by_sh);
        std::fflush(stdout);
      }
}
