#include "lambert/image/tonemap/bilateral.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lambert::tone {
namespace {

/// Sums of weights and of weighted values; the value axis is the innermost.
struct Grid {
  int width = 0, height = 0, depth = 0;
  std::vector<float> weights, values;
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(depth) +
           static_cast<std::size_t>(z);
  }
};

/// Where a coordinate lies between the grid's points.
struct Between {
  int first = 0;
  float second_weight = 0;
};

std::vector<Between> places(int count, float step) {
  std::vector<Between> all;
  for (int i = 0; i < count; ++i) {
    const float at = static_cast<float>(i) / step;
    const int first = static_cast<int>(at);
    all.push_back({first, at - static_cast<float>(first)});
  }
  return all;
}

/// Convolves along one axis with the Gaussian of variance `variance` (in cells); nothing lies beyond the grid.
void blur_axis(std::vector<float>& cells, std::size_t count, std::size_t stride, std::size_t lines_apart,
               std::size_t lines, float variance) {
  std::vector<float> kernel{1};
  for (int i = 1; static_cast<float>(i * i) < 16 * variance; ++i)
    kernel.push_back(std::exp(-0.5f * static_cast<float>(i * i) / variance));
  parallel_for(lines, [&](std::size_t line) {
    float* const first = cells.data() + line * lines_apart;
    // `stride` neighbouring cells are one vector of the convolution.
    std::vector<float> out(count * stride, 0.0f);
    for (std::size_t to = 0; to < count; ++to)
      for (std::size_t from = to < kernel.size() ? 0 : to - kernel.size() + 1;
           from < std::min(count, to + kernel.size()); ++from) {
        const float weight = kernel[to > from ? to - from : from - to];
        for (std::size_t i = 0; i < stride; ++i) out[to * stride + i] += weight * first[from * stride + i];
      }
    std::copy(out.begin(), out.end(), first);
  });
}

void blur(Grid& grid, float spatial_variance, float range_variance) {
  const auto w = static_cast<std::size_t>(grid.width), h = static_cast<std::size_t>(grid.height),
             d = static_cast<std::size_t>(grid.depth);
  for (std::vector<float>* cells : {&grid.weights, &grid.values}) {
    blur_axis(*cells, d, 1, d, w * h, range_variance);
    blur_axis(*cells, w, d, w * d, h, spatial_variance);
    // The columns as one line whose vectors are whole rows.
    blur_axis(*cells, h, w * d, w * h * d, 1, spatial_variance);
  }
}

}  // namespace

Plane bilateral_filter(const Plane& plane, float spatial, float range) {
  if (plane.values.empty()) return plane;
  const auto [low_at, high_at] = std::minmax_element(plane.values.begin(), plane.values.end());
  const float low = *low_at, high = *high_at;
  if (!(high > low)) return plane;

  constexpr float cells_per_deviation = 2;
  // A cell is at least a pixel: a kernel below that is taken as it comes out.
  const float step = std::max(spatial / cells_per_deviation, 1.0f);
  const float value_step = std::max(range, (high - low) / 200) / cells_per_deviation;
  const std::vector<Between> columns = places(plane.width, step), rows = places(plane.height, step);
  Grid grid{.width = columns.back().first + 2,
            .height = rows.back().first + 2,
            .depth = static_cast<int>((high - low) / value_step) + 2};
  grid.weights.assign(grid.index(0, grid.height, 0), 0.0f);
  grid.values = grid.weights;
  const auto depth = static_cast<std::size_t>(grid.depth);
  const float per_value = 1 / value_step;

  // Each row of the grid takes what belongs to it from the pixels of the two strips beside it.
  parallel_for(static_cast<std::size_t>(grid.height), [&](std::size_t grid_y) {
    for (std::size_t y = 0; y < rows.size(); ++y) {
      const auto first = static_cast<std::size_t>(rows[y].first);
      if (first != grid_y && first + 1 != grid_y) continue;
      const float row_weight = first == grid_y ? 1 - rows[y].second_weight : rows[y].second_weight;
      const auto row = plane.row(static_cast<int>(y));
      for (std::size_t x = 0; x < row.size(); ++x) {
        const float at = (row[x] - low) * per_value;
        const auto z = static_cast<std::size_t>(at);
        const float up = at - static_cast<float>(z);
        const std::size_t cell = grid.index(columns[x].first, static_cast<int>(grid_y), 0) + z;
        const float right = row_weight * columns[x].second_weight, left = row_weight - right;
        const float weights[4] = {left * (1 - up), left * up, right * (1 - up), right * up};
        const float value = row[x] - low;
        float* const w = grid.weights.data() + cell;
        float* const v = grid.values.data() + cell;
        w[0] += weights[0], w[1] += weights[1], w[depth] += weights[2], w[depth + 1] += weights[3];
        v[0] += weights[0] * value, v[1] += weights[1] * value;
        v[depth] += weights[2] * value, v[depth + 1] += weights[3] * value;
      }
    }
  });
  // Linear weights have the variance 1/6 of a cell on average, and are used twice.
  const auto narrowed = [](float deviation, float cell) {
    const float cells = deviation / cell;
    return std::max(cells * cells - 1.0f / 3.0f, 0.05f);
  };
  blur(grid, narrowed(spatial, step), narrowed(std::max(range, (high - low) / 200), value_step));

  Plane out(plane.width, plane.height);
  for_rows(plane.height, [&](int y) {
    const Between& row_at = rows[static_cast<std::size_t>(y)];
    const auto from = plane.row(y);
    const auto to = out.row(y);
    const std::size_t grid_row = static_cast<std::size_t>(grid.width) * depth;
    for (std::size_t x = 0; x < from.size(); ++x) {
      const float at = (from[x] - low) * per_value;
      const auto z = static_cast<std::size_t>(at);
      const float up = at - static_cast<float>(z);
      const std::size_t cell = grid.index(columns[x].first, row_at.first, 0) + z;
      const auto looked_up = [&](const std::vector<float>& cells) {
        const auto column = [&](std::size_t i) { return cells[i] + up * (cells[i + 1] - cells[i]); };
        const auto line = [&](std::size_t i) {
          const float left = column(i);
          return left + columns[x].second_weight * (column(i + depth) - left);
        };
        const float above = line(cell);
        return above + row_at.second_weight * (line(cell + grid_row) - above);
      };
      const float weight = looked_up(grid.weights);
      to[x] = weight > 0 ? low + looked_up(grid.values) / weight : from[x];
    }
  });
  return out;
}

}  // namespace lambert::tone
