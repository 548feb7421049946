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
  Level(Axis across, Axis down, std::vector<double> divergence)
      : x(std::move(across)),
        y(std::move(down)),
        solution(x.count() * y.count(), 0.0),
        right_side(std::move(divergence)),
        other(solution) {}
  std::size_t width() const { return x.count(); }
  std::size_t height() const { return y.count(); }
};

/// Rows of cells, of which the last `count` are kept.
struct Rows {
  const double* cells;
  std::size_t width, count;
  const double* operator[](std::size_t y) const { return cells + y % count * width; }
};
Rows all_rows(const Level& level) { return {level.solution.data(), level.width(), level.height()}; }

/// Calls body(x, A u - right side) along row y of u.
template <class Body>
void for_cells(const Level& level, const Rows& rows, std::size_t y, const Body& body) {
  const std::size_t w = level.width();
  const double* const u = rows[y];
  const double* const up = rows[y > 0 ? y - 1 : y];
  const double* const down = rows[y + 1 < level.height() ? y + 1 : y];
  const double* const f = level.right_side.data() + y * w;
  const double* const sizes = level.x.sizes.data();
  const double* const slopes = level.x.slopes.data();
  const double size = level.y.sizes[y], above = level.y.slopes[y], below = level.y.slopes[y + 1];
  const auto cell = [&](std::size_t x, double left, double right) {
    const double flux = size * (slopes[x + 1] * (right - u[x]) - slopes[x] * (u[x] - left)) +
                        sizes[x] * (below * (down[x] - u[x]) - above * (u[x] - up[x]));
    body(x, flux - f[x]);
  };
  cell(0, u[0], u[w > 1 ? 1 : 0]);
  for (std::size_t x = 1; x + 1 < w; ++x) cell(x, u[x - 1], u[x + 1]);
  if (w > 1) cell(w - 1, u[w - 2], u[w - 1]);
}

/// 1 / diagonal of A (without its sign) along a row, computed anew only for a row of other size or slopes.
class Inverses {
 public:
  explicit Inverses(const Level& level) : level_(level), values_(level.width()) {}
  const double* of_row(std::size_t y) {
    const double size = level_.y.sizes[y], slopes = level_.y.slopes[y] + level_.y.slopes[y + 1];
    if (size != size_ || slopes != slopes_)
      for (std::size_t x = 0; x < values_.size(); ++x)
        values_[x] = 1 / (size * (level_.x.slopes[x] + level_.x.slopes[x + 1]) + level_.x.sizes[x] * slopes);
    size_ = size, slopes_ = slopes;
    return values_.data();
  }

 private:
  const Level& level_;
  std::vector<double> values_;
  double size_ = 0, slopes_ = 0;
};

/// Three Jacobi steps whose weights are best for the upper half of the frequencies: the inverses of Chebyshev's points
/// in [1/2, 2], the eigenvalues there. The steps follow one another by a row, so that what they read is in a near
/// cache; the first two are also done for the rows beside a block that the next one reads.
void smooth(Level& level) {
  if (level.solution.size() == 1) return;
  const std::size_t w = level.width(), h = level.height();
  constexpr std::size_t kept = 4;
  for_row_blocks(static_cast<int>(h), [&](std::size_t, int begin, int end) {
    const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
    std::vector<double> once(kept * w), twice(kept * w);
    Inverses inverses(level);
    const auto step = [&](const Rows& from, double* to, std::size_t y, double weight) {
      const double* const u = from[y];
      const double* const inverse = inverses.of_row(y);
      for_cells(level, from, y, [&](std::size_t x, double excess) { to[x] = u[x] + weight * excess * inverse[x]; });
    };
    const auto within = [&](std::size_t y, std::size_t beside) {
      return y + beside >= first && y < std::min(last + beside, h);
    };
    for (std::size_t y = first - std::min<std::size_t>(first, 2); y < last + 2; ++y) {
      if (within(y, 2)) step(all_rows(level), once.data() + y % kept * w, y, 0.526);
      if (y >= 1 && within(y - 1, 1)) step({once.data(), w, kept}, twice.data() + (y - 1) % kept * w, y - 1, 0.8);
      if (y >= 2 && within(y - 2, 0)) step({twice.data(), w, kept}, level.other.data() + (y - 2) * w, y - 2, 1.665);
    }
  });
  std::swap(level.solution, level.other);
}

/// The residual summed over the fine cells of each coarse one; returns its largest magnitude in a fine cell.
double restrict_residual(const Level& fine, Level& coarse) {
  const std::size_t w = fine.width(), coarse_w = coarse.width();
  std::vector<double> largest(static_cast<std::size_t>(row_blocks(static_cast<int>(coarse.height()))));
  for_row_blocks(static_cast<int>(coarse.height()), [&](std::size_t block, int first, int last) {
    std::vector<double> residual(w), most(w);
    for (auto y = static_cast<std::size_t>(first); y < static_cast<std::size_t>(last); ++y) {
      double* const sums = coarse.right_side.data() + y * coarse_w;
      std::fill_n(sums, coarse_w, 0.0);
      for (std::size_t row = 2 * y; row < std::min(2 * y + 2, fine.height()); ++row) {
        for_cells(fine, all_rows(fine), row, [&](std::size_t x, double excess) { residual[x] = -excess; });
        for (std::size_t x = 0; x < w / 2; ++x) sums[x] += residual[2 * x] + residual[2 * x + 1];
        if (w % 2) sums[coarse_w - 1] += residual[w - 1];
        for (std::size_t x = 0; x < w; ++x) most[x] = std::max(most[x], std::abs(residual[x]));
      }
    }
    largest[block] = *std::ranges::max_element(most);
  });
  return *std::ranges::max_element(largest);
}

void add_interpolated(const Level& coarse, Level& fine) {
  const Interpolation across(fine.x, coarse.x), along(fine.y, coarse.y);
  const std::size_t w = fine.width(), coarse_w = coarse.width();
  for_row_blocks(static_cast<int>(fine.height()), [&](std::size_t, int first, int last) {
    std::vector<double> line(coarse_w);
    for (auto y = static_cast<std::size_t>(first); y < static_cast<std::size_t>(last); ++y) {
      const double* const a = coarse.solution.data() + along.first[y] * coarse_w;
      const double* const b = coarse.solution.data() + along.second[y] * coarse_w;
      const double t = along.weight[y];
      for (std::size_t x = 0; x < coarse_w; ++x) line[x] = a[x] + t * (b[x] - a[x]);
      for (std::size_t x = 0; x < w; ++x) {
        const double own = line[across.first[x]];
        fine.solution[y * w + x] += own + across.weight[x] * (line[across.second[x]] - own);
      }
    }
  });
}

/// False, before the coarser levels are asked, when no residual is above `enough`.
bool cycle(std::vector<Level>& levels, std::size_t index, double enough) {
  Level& fine = levels[index];
  smooth(fine);
  if (index + 1 == levels.size()) return true;
  Level& coarse = levels[index + 1];
  if (restrict_residual(fine, coarse) <= enough) return false;
  std::ranges::fill(coarse.solution, 0.0);
  cycle(levels, index + 1, 0);
  add_interpolated(coarse, fine);
  smooth(fine);
  return true;
}

double largest(const std::vector<double>& values) {
  return std::transform_reduce(
      values.begin(), values.end(), 0.0, [](double a, double b) { return std::max(a, b); },
      [](double v) { return std::abs(v); });
}

void remove_mean(std::vector<double>& values) {
  const double mean = std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
  for (double& v : values) v -= mean;
}

}  // namespace

std::vector<double> solve_poisson(int width, int height, std::vector<double> divergence) {
  remove_mean(divergence);
  const double enough = 1e-7 * largest(divergence);
  std::vector<Level> levels;
  levels.emplace_back(Axis(std::vector<double>(static_cast<std::size_t>(width), 1.0)),
                      Axis(std::vector<double>(static_cast<std::size_t>(height), 1.0)), std::move(divergence));
  while (levels.back().solution.size() > 1) {
    Axis x = levels.back().x.coarser(), y = levels.back().y.coarser();
    std::vector<double> zeros(x.count() * y.count(), 0.0);
    levels.emplace_back(std::move(x), std::move(y), std::move(zeros));
  }
  constexpr int most_cycles = 40;
  for (int i = 0; i < most_cycles && levels.size() > 1 && cycle(levels, 0, enough); ++i) {
  }
  std::vector<double> solution = std::move(levels.front().solution);
  remove_mean(solution);
  return solution;
}

}  // namespace lambert::tone
