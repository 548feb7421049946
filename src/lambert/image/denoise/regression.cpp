#include "lambert/image/denoise/regression.h"

#include "lambert/base/parallel.h"
#include "lambert/image/denoise/bilateral.h"
#include "lambert/image/denoise/patch_distance.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

namespace lambert::denoise {
namespace {

/// Eight pixels that are worked on together.
using Lanes = float __attribute__((vector_size(32)));
/// Windows stand in every second row, there at every fourth pixel, in turn from the first and from the third: a tile's
/// row of windows is one vector.
constexpr int lane_count = 8, row_step = 2, step = 4, window_rows = tile_size / row_step;
static_assert(lane_count * step == tile_size);
constexpr int shift(int row) { return row % 2 == 0 ? 0 : step / 2; }
constexpr int most_features = 7, first_feature = 3, most_unknowns = first_feature + most_features, most_radius = 10;

/// Of the pixel itself beside what the windows say of it: where it is like none of their centres, it stays as it is.
constexpr float own_weight = 0.02f;

Lanes load(const float* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
void store(float* to, Lanes v) { std::memcpy(to, &v, sizeof v); }
Lanes all(float v) { return Lanes{v, v, v, v, v, v, v, v}; }

/// A tile and what its windows reach, with the columns apart by their remainder, so that every fourth pixel is one
/// load.
class TilePlane {
 public:
  static constexpr int reach = tile_size + 2 * most_radius, part = reach / step + lane_count;
  /// The row of pixels tile.y + y: element i is pixel tile.x + x + step i.
  float* at(int x, int y) {
    const int column = x + most_radius;
    return values_.data() + ((y + most_radius) * step + column % step) * part + column / step;
  }
  void fill(const PaddedPlane& plane, Tile tile, int radius) {
    for (int y = -radius; y < tile_size + radius; ++y)
      for (int x = -radius; x < tile_size + radius; ++x) *at(x, y) = plane.row(tile.y + y)[tile.x + x];
  }
  void clear() { values_.fill(0); }

 private:
  std::array<float, static_cast<std::size_t>(reach* step* part)> values_;
};

/// The normal equations of eight windows: the lower triangle of Σ w f fᵀ, and Σ w f yᵀ.
struct Equations {
  std::array<std::array<Lanes, most_unknowns>, most_unknowns> m;
  std::array<std::array<Lanes, 3>, most_unknowns> y;
};

/// Solves in place by Cholesky's decomposition; the solution is in `y`. The ridge makes the matrix definite.
void solve(Equations& e, std::size_t unknowns, float ridge) {
  const Lanes penalty = e.m[0][0] * ridge + 1e-20f;
  for (std::size_t i = 0; i < unknowns; ++i) {
    if (i > 0) e.m[i][i] += penalty;
    for (std::size_t j = 0; j <= i; ++j) {
      Lanes sum = e.m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= e.m[i][k] * e.m[j][k];
      if (i != j) {
        e.m[i][j] = sum * e.m[j][j];
        continue;
      }
      // Kept as 1 / sqrt. Rounding may leave nothing, or less: then the feature says no more than those before it.
      std::array<float, lane_count> root;
      store(root.data(), i == 0 ? all(1e-20f) < sum ? sum : all(1e-20f) : penalty < sum ? sum : penalty);
      for (float& v : root) v = 1 / std::sqrt(v);
      e.m[i][i] = load(root.data());
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < unknowns; ++i) {
      Lanes sum = e.y[i][c];
      for (std::size_t k = 0; k < i; ++k) sum -= e.m[i][k] * e.y[k][c];
      e.y[i][c] = sum * e.m[i][i];
    }
    for (std::size_t i = unknowns; i-- > 0;) {
      Lanes sum = e.y[i][c];
      for (std::size_t k = i + 1; k < unknowns; ++k) sum -= e.m[k][i] * e.y[k][c];
      e.y[i][c] = sum * e.m[i][i];
    }
  }
}

/// Sums of weighted predictions, and of weights.
struct Told {
  std::array<TilePlane, 3> colour;
  TilePlane weight;
};

/// What a thread needs for one tile.
class TileRegression {
 public:
  /// No prediction is below `least`.
  TileRegression(const RegressionSettings& settings, std::size_t features, float least)
      : settings_(settings), features_(features), least_(all(least)) {
    const auto across = static_cast<std::size_t>(2 * settings.window_radius + 1);
    weights_.resize(across * across * window_rows * lane_count);
  }

  void run(Tile tile, const PatchGuide& guide, std::span<const PaddedPlane> colour,
           std::span<const PaddedPlane> features) {
    const int radius = settings_.window_radius;
    TileWeights by_patches(guide, tile, row_step, settings_.patch_radius, 1 / (settings_.k * settings_.k));
    float* to = weights_.data();
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const float* from = by_patches.at(dx, dy);
        for (int j = 0; j < window_rows; ++j, from += by_patches.side())
          for (int i = 0; i < lane_count; ++i) *to++ = from[(shift(j) + step * i) / row_step];
      }
    for (std::size_t c = 0; c < 3; ++c) colour_[c].fill(colour[c], tile, radius);
    for (std::size_t f = 0; f < features_; ++f) feature_[f].fill(features[f], tile, radius);
    for (Told& t : told_) {
      for (TilePlane& plane : t.colour) plane.clear();
      t.weight.clear();
    }
    for (int j = 0; j < window_rows; ++j) windows(j);
  }

  Told& told(std::size_t candidate) { return told_[candidate]; }

 private:
  static constexpr int most_across = 2 * most_radius + 1;
  std::size_t unknowns() const { return first_feature + features_; }
  int radius_of(std::size_t candidate) const {
    return candidate == 0 ? settings_.window_radius : std::min(settings_.narrow_radius, settings_.window_radius);
  }

  /// Features and weights of the eight windows' partners in one row.
  void gather_row(int j, int dy, const std::array<Lanes, most_features>& centre) {
    const int radius = settings_.window_radius, x = shift(j), y = j * row_step + dy;
    const int across = 2 * radius + 1;
    for (int s = 0; s < across; ++s) {
      const int dx = s - radius;
      const auto at = static_cast<std::size_t>(s);
      const std::size_t offset = static_cast<std::size_t>((dy + radius) * across + s);
      const Lanes w = load(weights_.data() + (offset * window_rows + static_cast<std::size_t>(j)) * lane_count);
      w_[0][at] = w;
      w_[1][at] = w * w * (w * w);
      f_[0][at] = all(1);
      f_[1][at] = all(static_cast<float>(dx) / static_cast<float>(radius));
      f_[2][at] = all(static_cast<float>(dy) / static_cast<float>(radius));
      for (std::size_t f = 0; f < features_; ++f)
        f_[first_feature + f][at] = load(feature_[f].at(x + dx, y)) - centre[f];
    }
  }

  /// Fits the windows of row j, and lets them speak.
  void windows(int j) {
    const int radius = settings_.window_radius, x = shift(j), y = j * row_step;
    std::array<Lanes, most_features> centre;
    for (std::size_t f = 0; f < features_; ++f) centre[f] = load(feature_[f].at(x, y));
    std::memset(static_cast<void*>(&equations_), 0, sizeof equations_);
    for (int dy = -radius; dy <= radius; ++dy) {
      gather_row(j, dy, centre);
      for (std::size_t c = 0; c < 3; ++c)
        for (int s = 0; s <= 2 * radius; ++s)
          y_[c][static_cast<std::size_t>(s)] = load(colour_[c].at(x + s - radius, y + dy));
      for (std::size_t k = 0; k < candidate_count; ++k)
        if (std::abs(dy) <= radius_of(k)) accumulate(k);
    }
    for (Equations& e : equations_) solve(e, unknowns(), settings_.ridge);
    for (int dy = -radius; dy <= radius; ++dy) {
      gather_row(j, dy, centre);
      for (std::size_t k = 0; k < candidate_count; ++k)
        if (std::abs(dy) <= radius_of(k)) predict(k, x, y + dy);
    }
  }

  void accumulate(std::size_t candidate) {
    Equations& e = equations_[candidate];
    const auto first = static_cast<std::size_t>(settings_.window_radius - radius_of(candidate));
    const auto last = static_cast<std::size_t>(settings_.window_radius + radius_of(candidate)) + 1;
    std::array<Lanes, most_across> wf;
    for (std::size_t i = 0; i < unknowns(); ++i) {
      for (std::size_t s = first; s < last; ++s) wf[s] = w_[candidate][s] * f_[i][s];
      std::size_t k = 0;
      for (; k + 4 <= i + 1; k += 4) add_products<4>(&e.m[i][k], wf.data(), &f_[k], first, last);
      for (; k <= i; ++k) add_products<1>(&e.m[i][k], wf.data(), &f_[k], first, last);
      add_products<3>(e.y[i].data(), wf.data(), y_, first, last);
    }
  }

  /// sums[n] += a · b[n] for N vectors at once, whose chains of additions do not wait for each other.
  template <int N>
  static void add_products(Lanes* sums, const Lanes* a, const std::array<Lanes, most_across>* b, std::size_t first,
                           std::size_t last) {
    std::array<Lanes, N> sum;
    for (std::size_t n = 0; n < N; ++n) sum[n] = sums[n];
    for (std::size_t s = first; s < last; ++s)
      for (std::size_t n = 0; n < N; ++n) sum[n] += a[s] * b[n][s];
    for (std::size_t n = 0; n < N; ++n) sums[n] = sum[n];
  }

  void predict(std::size_t candidate, int x, int y) {
    const Equations& e = equations_[candidate];
    Told& told = told_[candidate];
    const int radius = radius_of(candidate);
    for (int dx = -radius; dx <= radius; ++dx) {
      const auto s = static_cast<std::size_t>(settings_.window_radius + dx);
      const Lanes w = w_[candidate][s];
      std::array<Lanes, 3> value{e.y[0][0], e.y[0][1], e.y[0][2]};
      for (std::size_t i = 1; i < unknowns(); ++i)
        for (std::size_t c = 0; c < 3; ++c) value[c] += e.y[i][c] * f_[i][s];
      for (std::size_t c = 0; c < 3; ++c) {
        float* to = told.colour[c].at(x + dx, y);
        store(to, load(to) + w * (value[c] > least_ ? value[c] : least_));
      }
      float* to = told.weight.at(x + dx, y);
      store(to, load(to) + w);
    }
  }

  const RegressionSettings& settings_;
  std::size_t features_;
  Lanes least_;
  std::vector<float> weights_;
  std::array<TilePlane, 3> colour_;
  std::array<TilePlane, most_features> feature_;
  std::array<Told, candidate_count> told_;
  std::array<Equations, candidate_count> equations_;
  std::array<std::array<Lanes, most_across>, candidate_count> w_;
  std::array<Lanes, most_across> f_[most_unknowns];
  std::array<Lanes, most_across> y_[3];
};

/// Sums over the whole picture.
struct Sums {
  Colour colour;
  Plane weight;
};

void add(Sums& to, Told& told, Tile tile, int radius) {
  const int width = to.weight.width(), height = to.weight.height();
  for (int y = std::max(-radius, -tile.y); y < std::min(tile_size + radius, height - tile.y); ++y)
    for (int x = std::max(-radius, -tile.x); x < std::min(tile_size + radius, width - tile.x); ++x) {
      for (std::size_t c = 0; c < 3; ++c) to.colour[c].at(tile.x + x, tile.y + y) += *told.colour[c].at(x, y);
      to.weight.at(tile.x + x, tile.y + y) += *told.weight.at(x, y);
    }
}

}  // namespace

Candidates regress(const Colour& colour, const Colour& guide, const Colour& variance, std::span<const Plane> features,
                   const RegressionSettings& settings, const FractionSink& progress) {
  const int width = colour[0].width(), height = colour[0].height(), radius = settings.window_radius;
  const PatchGuide patches(guide, variance, radius, settings.patch_radius, colour_axes(guide, 2, settings.colour));
  std::vector<PaddedPlane> colours, guides;
  for (const Plane& plane : colour) colours.emplace_back(plane, radius + tile_size);
  for (const Plane& plane : features) guides.emplace_back(plane, radius + tile_size);
  std::array<Sums, candidate_count> sums;
  for (Sums& s : sums) s = {black(width, height), Plane(width, height)};

  // Slopes may lead below zero, where light never is.
  float least = 0;
  for (const Plane& plane : colour)
    least = std::min(least, *std::min_element(plane.values().begin(), plane.values().end()));

  // Windows reach into the neighbouring tiles: of every 2x2 tiles one at a time, so that no two tiles that are worked
  // on touch the same pixel and each pixel's sum has one order.
  const int columns = (width + tile_size - 1) / tile_size, rows = (height + tile_size - 1) / tile_size;
  for (int phase = 0; phase < 4; ++phase) {
    const int first_column = phase % 2, first_row = phase / 2;
    const int across = (columns - first_column + 1) / 2, down = (rows - first_row + 1) / 2;
    parallel_for(static_cast<std::size_t>(across * down), part_of(progress, 0.25 * phase, 0.25 * (phase + 1)),
                 [&](std::size_t i) {
                   const int column = first_column + 2 * (static_cast<int>(i) % across);
                   const int row = first_row + 2 * (static_cast<int>(i) / across);
                   const Tile tile{column * tile_size, row * tile_size};
                   const auto work = std::make_unique<TileRegression>(settings, features.size(), least);
                   work->run(tile, patches, colours, guides);
                   for (std::size_t k = 0; k < candidate_count; ++k) add(sums[k], work->told(k), tile, radius);
                 });
  }
  Candidates result;
  for (std::size_t k = 0; k < candidate_count; ++k) {
    result[k] = colour;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < colour[c].values().size(); ++i)
        result[k][c].values()[i] = (sums[k].colour[c].values()[i] + own_weight * colour[c].values()[i]) /
                                   (sums[k].weight.values()[i] + own_weight);
  }
  return result;
}

}  // namespace lambert::denoise
