#include "lambert/sampling/patterns.h"

#include "lambert/base/error.h"
#include "lambert/base/hash.h"
#include "lambert/sampling/sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace lambert {
namespace {

constexpr std::array<std::pair<std::string_view, PatternKind>, 6> kinds{{
    {"regular", PatternKind::regular},
    {"random", PatternKind::random},
    {"jittered", PatternKind::jittered},
    {"poisson-disk", PatternKind::poisson_disk},
    {"best-candidate", PatternKind::best_candidate},
    {"sobol", PatternKind::sobol},
}};

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(mix_bits(seed + 0x632be59bd9b4e019ull)) {}
  float next() { return hash_to_float(mix_bits(state_ += 0x9e3779b97f4a7c15ull)); }
  Vec2 pair() {
    const float x = next();
    return {x, next()};
  }

 private:
  std::uint64_t state_;
};

/// The squared distance on the torus.
double distance_squared(Vec2 a, Vec2 b) {
  const auto along = [](float p, float q) {
    const double d = std::abs(static_cast<double>(p) - static_cast<double>(q));
    return std::min(d, 1 - d);
  };
  const double x = along(a.x, b.x), y = along(a.y, b.y);
  return x * x + y * y;
}

/// Points in cells of a torus, so that near ones are found in near cells.
class TorusGrid {
 public:
  explicit TorusGrid(int side) : side_(side), cells_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}

  void add(Vec2 p) { cells_[index(cell(p.x), cell(p.y))].push_back(p); }

  /// The squared distance of the nearest point, or anything not above `enough` as soon as one so near is found.
  double nearest(Vec2 p, double enough) const {
    double best = std::numeric_limits<double>::infinity();
    const double cell_size = 1.0 / side_;
    for (int ring = 0; 2 * ring <= side_ + 1; ++ring) {
      // All points of ring k lie at least (k - 1) cells away.
      const double reach = std::max(0, ring - 1) * cell_size;
      if (best <= reach * reach || best <= enough) break;
      visit(p, ring, best);
    }
    return best;
  }

 private:
  void visit(Vec2 p, int ring, double& best) const {
    const int x = cell(p.x), y = cell(p.y);
    for (int dy = -ring; dy <= ring; ++dy) {
      const int step = std::abs(dy) == ring || ring == 0 ? 1 : 2 * ring;
      for (int dx = -ring; dx <= ring; dx += step)
        for (const Vec2 q : cells_[index(wrapped(x + dx), wrapped(y + dy))])
          best = std::min(best, distance_squared(p, q));
    }
  }
  int cell(float v) const { return std::min(side_ - 1, static_cast<int>(v * static_cast<float>(side_))); }
  int wrapped(int i) const { return ((i % side_) + side_) % side_; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }

  int side_;
  std::vector<std::vector<Vec2>> cells_;
};

int square_side(int count, std::string_view name) {
  const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count))));
  if (count < 1 || side * side != count)
    throw Error("a " + std::string(name) + " pattern needs a square number of points, not " + std::to_string(count));
  return side;
}

}  // namespace

PatternKind pattern_kind(std::string_view name) {
  for (const auto& [known, kind] : kinds)
    if (known == name) return kind;
  throw Error("unknown pattern " + unknown_word(name, pattern_names()));
}

std::vector<std::string> pattern_names() {
  std::vector<std::string> names;
  for (const auto& entry : kinds) names.emplace_back(entry.first);
  return names;
}

std::vector<Vec2> regular_points(int side) {
  std::vector<Vec2> points;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      points.push_back((Vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) / static_cast<float>(side));
  return points;
}

std::vector<Vec2> random_points(int count, std::uint64_t seed) {
  Numbers numbers(seed);
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) points.push_back(numbers.pair());
  return points;
}

std::vector<Vec2> jittered_points(int side, std::uint64_t seed) {
  Numbers numbers(seed);
  std::vector<Vec2> points;
  // Rounding may not carry a point out of the square.
  constexpr float below_one = 1 - 0x1p-24f;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      points.push_back(glm::min(
          (Vec2(static_cast<float>(x), static_cast<float>(y)) + numbers.pair()) / static_cast<float>(side), below_one));
  return points;
}

std::vector<Vec2> poisson_disk_points(double radius, int count, std::uint64_t seed, int most_misses) {
  if (!(radius > 0) || !(radius < 0.5)) throw Error("the radius of a Poisson-disk pattern must be between 0 and 0.5");
  Numbers numbers(seed);
  TorusGrid grid(std::clamp(static_cast<int>(1 / radius), 1, 1024));
  std::vector<Vec2> points;
  for (int misses = 0; misses < most_misses && static_cast<int>(points.size()) < count;) {
    const Vec2 dart = numbers.pair();
    if (grid.nearest(dart, 0) < radius * radius) {
      ++misses;
      continue;
    }
    misses = 0;
    grid.add(dart);
    points.push_back(dart);
  }
  return points;
}

double poisson_disk_radius(int count) {
  // Hexagonal packing: n points of separation r cover n r² √3/2 of the square.
  return std::min(0.49, 0.74 * std::sqrt(2 / (std::numbers::sqrt3 * std::max(1, count))));
}

std::vector<Vec2> best_candidate_points(int count, std::uint64_t seed, int candidates_per_point) {
  Numbers numbers(seed);
  TorusGrid grid(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(std::max(1, count)))), 1, 1024));
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    Vec2 best = numbers.pair();
    double farthest = grid.nearest(best, 0);
    for (int k = 1; k < candidates_per_point * i; ++k) {
      const Vec2 candidate = numbers.pair();
      const double distance = grid.nearest(candidate, farthest);
      if (distance > farthest) farthest = distance, best = candidate;
    }
    grid.add(best);
    points.push_back(best);
  }
  return points;
}

std::vector<Vec2> pattern_points(PatternKind kind, int count, std::uint64_t seed) {
  if (count < 1) throw Error("a pattern needs at least one point");
  switch (kind) {
    case PatternKind::regular: return regular_points(square_side(count, "regular"));
    case PatternKind::random: return random_points(count, seed);
    case PatternKind::jittered: return jittered_points(square_side(count, "jittered"), seed);
    case PatternKind::poisson_disk: return poisson_disk_points(poisson_disk_radius(count), count, seed);
    case PatternKind::best_candidate: return best_candidate_points(count, seed);
    case PatternKind::sobol: break;
  }
  std::vector<Vec2> points;
  const SamplerSettings settings{
      .kind = SamplerKind::sobol, .samples_per_pixel = static_cast<std::uint32_t>(count), .seed = seed};
  for (int i = 0; i < count; ++i) points.push_back(Sampler(settings, {0, 0}, static_cast<std::uint32_t>(i)).next2());
  return points;
}

double smallest_separation(const std::vector<Vec2>& points) {
  TorusGrid grid(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(points.size()))), 1, 1024));
  double best = std::numeric_limits<double>::infinity();
  for (const Vec2 p : points) {
    best = std::min(best, grid.nearest(p, 0));
    grid.add(p);
  }
  return std::sqrt(best);
}

}  // namespace lambert
