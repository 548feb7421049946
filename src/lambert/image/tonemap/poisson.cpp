#include "lambert/image/tonemap/poisson.h"

#include "lambert/image/plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace lambert::tone {
namespace {

/// Cells along one axis. Of an odd count, the last cell of the next coarser level is as small as its only fine one.
struct Axis {
  std::vector<double> sizes;
  std::vector<double> slopes;  ///< 1 / distance of the centres of i - 1 and i; 0 at both ends: no flux there

  explicit Axis(std::vector<double> cells) : sizes(std::move(cells)), slopes(sizes.size() + 1, 0.0) {
    for (std::size_t i = 1; i < sizes.size(); ++i) slopes[i] = 2 / (sizes[i - 1] + sizes[i]);
  }
  std::size_t count() const { return sizes.size(); }
  Axis coarser() const {
    std::vector<double> pairs;
    for (std::size_t i = 0; i < sizes.size(); i += 2)
      pairs.push_back(sizes[i] + (i + 1 < sizes.size() ? sizes[i + 1] : 0));
    return Axis(std::move(pairs));
  }
};

/// For each fine cell the coarse ones about its centre and the weight of the second.
struct Interpolation {
  std::vector<std::size_t> first, second;
  std::vector<double> weight;

  Interpolation(const Axis& fine, const Axis& coarse) {
    std::vector<double> centres;
    double edge = 0;
    for (const double s : coarse.sizes) centres.push_back(edge + s / 2), edge += s;
    edge = 0;
    for (std::size_t i = 0; i < fine.count(); ++i) {
      const double at = edge + fine.sizes[i] / 2;
      edge += fine.sizes[i];
      const std::size_t own = i / 2;
      const std::size_t other = at < centres[own] ? (own > 0 ? own - 1 : own) : std::min(own + 1, coarse.count() - 1);
      first.push_back(own), second.push_back(other);
      weight.push_back(other == own ? 0.0 : (at - centres[own]) / (centres[other] - centres[own]));
    }
  }
};

struct Level {
  Axis x, y;
  std::vector<double> solution, right_side, other;
  Level(Axis across, Axis down) : x(std::move(across)), y(std::move(down)) {
    solution.assign(x.count() * y.count(), 0.0);
    right_side = other = solution;
  }
};

/// out = from + weight (A from - right side) / diagonal; with a weight of 0 the residual right side - A from instead.
void relax_row(const Level& level, const double* from, double* out, std::size_t y, double weight) {
  const std::size_t w = level.x.count(), h = level.y.count();
  const double* const u = from + y * w;
  const double* const up = from + (y > 0 ? y - 1 : y) * w;
  const double* const down = from + (y + 1 < h ? y + 1 : y) * w;
  const double* const f = level.right_side.data() + y * w;
  const double* const sizes = level.x.sizes.data();
  const double* const slopes = level.x.slopes.data();
  const double size = level.y.sizes[y], above = level.y.slopes[y], below = level.y.slopes[y + 1];
  double* const to = out + y * w;
  const auto cell = [&](std::size_t x, double left, double right) {
    const double flux = size * (slopes[x + 1] * (right - u[x]) - slopes[x] * (u[x] - left)) +
                        sizes[x] * (below * (down[x] - u[x]) - above * (u[x] - up[x]));
    const double diagonal = size * (slopes[x] + slopes[x + 1]) + sizes[x] * (above + below);
    to[x] = weight != 0 ? u[x] + weight * (flux - f[x]) / diagonal : f[x] - flux;
  };
  cell(0, u[0], u[w > 1 ? 1 : 0]);
  for (std::size_t x = 1; x + 1 < w; ++x) cell(x, u[x - 1], u[x + 1]);
  if (w > 1) cell(w - 1, u[w - 2], u[w - 1]);
}

void for_level_rows(const Level& level, const std::function<void(std::size_t)>& body) {
  for_rows(static_cast<int>(level.y.count()), [&](int y) { body(static_cast<std::size_t>(y)); });
}

/// Three Jacobi steps whose weights are best for the upper half of the frequencies: the inverses of Chebyshev's points
/// in [1/2, 2], the eigenvalues there.
void smooth(Level& level) {
  if (level.solution.size() == 1) return;
  for (const double weight : {0.526, 0.8, 1.665}) {
    for_level_rows(level,
                   [&](std::size_t y) { relax_row(level, level.solution.data(), level.other.data(), y, weight); });
    std::swap(level.solution, level.other);
  }
}

void cycle(std::vector<Level>& levels, std::size_t index) {
  Level& fine = levels[index];
  smooth(fine);
  if (index + 1 == levels.size()) return;
  Level& coarse = levels[index + 1];
  for_level_rows(fine, [&](std::size_t y) { relax_row(fine, fine.solution.data(), fine.other.data(), y, 0); });
  const std::size_t w = fine.x.count(), coarse_w = coarse.x.count();
  std::fill(coarse.right_side.begin(), coarse.right_side.end(), 0.0);
  std::fill(coarse.solution.begin(), coarse.solution.end(), 0.0);
  for_level_rows(coarse, [&](std::size_t y) {
    for (std::size_t row = 2 * y; row < std::min(2 * y + 2, fine.y.count()); ++row)
      for (std::size_t x = 0; x < w; ++x) coarse.right_side[y * coarse_w + x / 2] += fine.other[row * w + x];
  });
  cycle(levels, index + 1);
  const Interpolation across(fine.x, coarse.x), along(fine.y, coarse.y);
  for_level_rows(fine, [&](std::size_t y) {
    const double* const a = coarse.solution.data() + along.first[y] * coarse_w;
    const double* const b = coarse.solution.data() + along.second[y] * coarse_w;
    const double t = along.weight[y];
    std::vector<double> line(coarse_w);
    for (std::size_t x = 0; x < coarse_w; ++x) line[x] = a[x] + t * (b[x] - a[x]);
    for (std::size_t x = 0; x < w; ++x) {
      const double own = line[across.first[x]];
      fine.solution[y * w + x] += own + across.weight[x] * (line[across.second[x]] - own);
    }
  });
  smooth(fine);
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

void remove_mean(std::vector<double>& values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (double& v : values) v -= mean;
}

}  // namespace

std::vector<double> solve_poisson(int width, int height, std::vector<double> divergence) {
  std::vector<Level> levels;
  levels.emplace_back(Axis(std::vector<double>(static_cast<std::size_t>(width), 1.0)),
                      Axis(std::vector<double>(static_cast<std::size_t>(height), 1.0)));
  while (levels.back().solution.size() > 1) {
    const Level& finest = levels.back();
    levels.emplace_back(finest.x.coarser(), finest.y.coarser());
  }
  remove_mean(divergence);
  const double enough = 1e-7 * largest(divergence);
  Level& finest = levels.front();
  finest.right_side = std::move(divergence);
  for (int i = 0; i < 40 && levels.size() > 1; ++i) {
    cycle(levels, 0);
    for_level_rows(finest,
                   [&](std::size_t y) { relax_row(finest, finest.solution.data(), finest.other.data(), y, 0); });
    if (largest(finest.other) <= enough) break;
  }
  remove_mean(finest.solution);
  return std::move(finest.solution);
}

}  // namespace lambert::tone
