#include "lambert/image/probe/irradiance.h"

#include "lambert/base/parallel.h"
#include "lambert/image/probe/texels.h"

#include <algorithm>
#include <cmath>

namespace lambert::probe {
namespace {

/// The blocks of one level of a chart, their number a power of two along each side.
struct Grid {
  int columns, rows;
};

int power_of_two_at_most(int n) {
  int p = 1;
  while (2 * p <= n) p *= 2;
  return p;
}

}  // namespace

Irradiance::Irradiance(const Probe& probe) {
  struct Block {
    Node node;
    float angle;  // the cone's half angle
  };
  const TexelMeasure measure = texel_measure(probe);
  const int charts = static_cast<int>(probe.charts.size());
  // Leaves: as many blocks as there are texels, or fewer, a power of two along each side so that four make one.
  Grid leaves{power_of_two_at_most(probe.width()), power_of_two_at_most(probe.height())};
  while (static_cast<std::int64_t>(leaves.columns) * leaves.rows * charts > (1 << 19))
    leaves.columns = std::max(1, leaves.columns / 2), leaves.rows = std::max(1, leaves.rows / 2);

  std::vector<Block> level(static_cast<std::size_t>(leaves.columns) * static_cast<std::size_t>(leaves.rows) *
                           static_cast<std::size_t>(charts));
  parallel_for(static_cast<std::size_t>(leaves.rows * charts), [&](std::size_t i) {
    const int chart = static_cast<int>(i) / leaves.rows, row = static_cast<int>(i) % leaves.rows;
    const Image& image = probe.charts[static_cast<std::size_t>(chart)];
    const auto first = [](int block, int blocks, int n) {
      return static_cast<int>(static_cast<std::int64_t>(block) * n / blocks);
    };
    const int y0 = first(row, leaves.rows, image.height()), y1 = first(row + 1, leaves.rows, image.height());
    for (int column = 0; column < leaves.columns; ++column) {
      const int x0 = first(column, leaves.columns, image.width());
      const int x1 = first(column + 1, leaves.columns, image.width());
      Block& block = level[i * static_cast<std::size_t>(leaves.columns) + static_cast<std::size_t>(column)];
      block.node = {{Vec3(0), Vec3(0), Vec3(0)}, Vec3(0), 1, 0, 0};
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
          const auto at =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width()) + static_cast<std::size_t>(x);
          const Vec3 moment = texel_moment(probe, chart, x, y, measure.solid_angle[at]);
          const Rgb c = image.rgb(x, y);
          for (int k = 0; k < 3; ++k) block.node.moment[static_cast<std::size_t>(k)] += c[k] * moment;
          block.node.axis += moment;
        }
      const float size = length(block.node.axis);
      block.node.axis = size > 0 ? block.node.axis / size : Vec3(0, 0, 1);
      block.angle = 0;
      for (const Vec2 corner : {Vec2(x0, y0), Vec2(x1, y0), Vec2(x0, y1), Vec2(x1, y1)})
        if (const auto d = direction(probe.projection, {chart, uv_of(probe, corner)}))
          block.angle = std::max(block.angle, std::acos(std::clamp(dot(*d, block.node.axis), -1.0f, 1.0f)));
        else
          block.angle = std::max(block.angle, size > 0 ? 2 * std::sqrt(size) : 0.0f);
    }
  });

  // Upwards: each level in front of what it was made of.
  std::vector<std::vector<Block>> levels{std::move(level)};
  std::vector<Grid> grids{leaves};
  while (grids.back().columns > 1 && grids.back().rows > 1) {
    const Grid below = grids.back(), grid{below.columns / 2, below.rows / 2};
    const std::vector<Block>& from = levels.back();
    std::vector<Block> to;
    to.reserve(from.size() / 4);
    for (int chart = 0; chart < charts; ++chart)
      for (int y = 0; y < grid.rows; ++y)
        for (int x = 0; x < grid.columns; ++x) {
          Block block{{{Vec3(0), Vec3(0), Vec3(0)}, Vec3(0), 1, 0, 0}, 0};
          std::array<const Block*, 4> parts{};
          Vec3 axis(0);
          for (int k = 0; k < 4; ++k) {
            const int cx = 2 * x + (k & 1), cy = 2 * y + (k >> 1);
            parts[static_cast<std::size_t>(k)] =
                &from[static_cast<std::size_t>((chart * below.rows + cy) * below.columns + cx)];
            const Block& part = *parts[static_cast<std::size_t>(k)];
            for (std::size_t c = 0; c < 3; ++c) block.node.moment[c] += part.node.moment[c];
            axis += part.node.axis;
          }
          block.node.axis = length_squared(axis) > 1e-6f ? normalize(axis) : Vec3(0, 0, 1);
          for (const Block* part : parts)
            block.angle = std::max(
                block.angle, part->angle + std::acos(std::clamp(dot(part->node.axis, block.node.axis), -1.0f, 1.0f)));
          to.push_back(block);
        }
    levels.push_back(std::move(to));
    grids.push_back(grid);
  }

  std::vector<std::size_t> starts(levels.size());
  std::size_t total = 0;
  for (std::size_t l = levels.size(); l-- > 0;) starts[l] = total, total += 4 * ((levels[l].size() + 3) / 4);
  nodes_.resize(total, Node{{Vec3(0), Vec3(0), Vec3(0)}, Vec3(0, 0, 1), 1, 0, 0});
  // Four siblings stand side by side: their place is that of their parent.
  roots_ = static_cast<std::uint32_t>(levels.back().size());
  std::vector<std::uint32_t> places(levels.back().size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<std::uint32_t>(i);
  for (std::size_t l = levels.size(); l-- > 0;) {
    const Grid grid = grids[l];
    std::vector<std::uint32_t> below(l > 0 ? levels[l - 1].size() : 0);
    for (std::size_t i = 0; i < levels[l].size(); ++i) {
      Node node = levels[l][i].node;
      const float angle = std::min(levels[l][i].angle * 1.01f + 1e-5f, pi);
      node.cos_radius = std::cos(angle), node.sin_radius = std::sin(angle);
      if (angle >= 0.5f * pi) node.cos_radius = -1;  // always split
      if (l > 0) {
        node.children =
            static_cast<std::uint32_t>(starts[l - 1]) + 4 * (places[i] - static_cast<std::uint32_t>(starts[l]));
        const int x = static_cast<int>(i) % grid.columns, row = static_cast<int>(i) / grid.columns;
        const int chart = row / grid.rows, y = row % grid.rows;
        for (int k = 0; k < 4; ++k)
          below[static_cast<std::size_t>((chart * grids[l - 1].rows + 2 * y + (k >> 1)) * grids[l - 1].columns + 2 * x +
                                         (k & 1))] = node.children + static_cast<std::uint32_t>(k);
      }
      nodes_[places[i]] = node;
    }
    places = std::move(below);
  }
}

void Irradiance::add(std::uint32_t index, Vec3 normal, std::array<double, 3>& sum) const {
  const Node& node = nodes_[index];
  const float c = dot(normal, node.axis);
  if (node.cos_radius > 0 || node.children == 0) {
    if (c <= -node.sin_radius) return;
    if (c >= node.sin_radius || node.children == 0) {
      // On the horizon a leaf's cosines are spread about evenly over c ± w, w that of a square with its corners on the
      // cone; the mean of max(0, cosine) is then (c + w)² / 4w.
      const float w = 0.7071f * node.sin_radius;
      const bool whole = c >= w;
      if (c <= -w) return;
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += static_cast<double>(whole ? dot(normal, node.moment[k])
                                            : dot(node.axis, node.moment[k]) * sqr(c + w) / (4 * w));
      return;
    }
  }
  for (std::uint32_t k = 0; k < 4; ++k) add(node.children + k, normal, sum);
}

Rgb Irradiance::operator()(Vec3 normal) const {
  std::array<double, 3> sum{};
  for (std::uint32_t i = 0; i < roots_; ++i) add(i, normal, sum);
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

Probe diffuse_map(const Probe& probe, int rows) {
  const Irradiance irradiance(probe);
  const Vec2i size = chart_size(probe.projection, rows);
  Probe result{probe.projection, probe.texels, {}};
  for (std::size_t i = 0; i < probe.charts.size(); ++i) result.charts.emplace_back(size.x, size.y, rgb_channels());
  for (std::size_t i = 0; i < result.charts.size(); ++i)
    parallel_for(static_cast<std::size_t>(size.y), [&](std::size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < size.x; ++x)
        if (const auto d = direction(result.projection, {static_cast<int>(i), uv_of(result, Vec2(x, y) + 0.5f)}))
          result.charts[i].set_rgb(x, y, irradiance(*d) * inv_pi);
    });
  return result;
}

}  // namespace lambert::probe
