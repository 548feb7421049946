#include "lambert/sampling/patterns.h"

#include "lambert/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lambert {
namespace {

double brute_force_separation(const std::vector<Vec2>& points) {
  double best = INFINITY;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
          best = std::min(best, std::hypot(static_cast<double>(points[i].x) - static_cast<double>(points[j].x) + dx,
                                           static_cast<double>(points[i].y) - static_cast<double>(points[j].y) + dy));
  return best;
}

TEST(Patterns, HaveTheirNumberOfPointsInTheSquare) {
  for (const std::string& name : pattern_names())
    for (const int count : {1, 4, 81, 256}) {
      const auto points = pattern_points(pattern_kind(name), count, 7);
      EXPECT_EQ(points.size(), static_cast<std::size_t>(count)) << name;
      for (const Vec2 p : points) ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << name;
      EXPECT_EQ(points, pattern_points(pattern_kind(name), count, 7)) << name;
    }
  EXPECT_THROW(pattern_points(PatternKind::jittered, 12, 0), Error);
  EXPECT_THROW(pattern_kind("poison"), Error);
}

// rows: AA-13
TEST(Patterns, JitterPutsOnePointInEachCellAndGuaranteesNoSeparation) {
  double smallest = INFINITY;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = jittered_points(32, seed);
    std::set<std::pair<int, int>> cells;
    for (const Vec2 p : points) cells.emplace(static_cast<int>(p.x * 32), static_cast<int>(p.y * 32));
    EXPECT_EQ(cells.size(), 1024u);
    smallest = std::min(smallest, 32 * smallest_separation(points));
  }
  EXPECT_LT(smallest, 0.1) << "cells wide";
}

// rows: AA-18
TEST(Patterns, DartsKeepTheirDistance) {
  for (const double radius : {0.02, 0.1, 0.3}) {
    const auto points = poisson_disk_points(radius, 100000, 3, 2000);
    EXPECT_GE(smallest_separation(points), radius - 1e-7);
    EXPECT_NEAR(smallest_separation(points), brute_force_separation(points), 1e-12);
    // Saturated: of a maximal set every place is within the radius, so disks of it cover the square.
    EXPECT_GT(static_cast<double>(points.size()) * 3.15 * radius * radius, 1);
  }
  EXPECT_THROW(poisson_disk_points(0, 1, 0), Error);
}

// rows: AA-19
TEST(Patterns, EveryPrefixOfBestCandidatesIsWellSpread) {
  const auto points = best_candidate_points(512, 11);
  const auto random = random_points(512, 11);
  for (const std::size_t n : {16u, 64u, 256u, 512u}) {
    const std::vector<Vec2> prefix(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n));
    const std::vector<Vec2> poor(random.begin(), random.begin() + static_cast<std::ptrdiff_t>(n));
    const double packed = std::sqrt(2 / (std::sqrt(3.0) * static_cast<double>(n)));
    EXPECT_GT(smallest_separation(prefix), 0.5 * packed) << n;
    if (n >= 64) EXPECT_LT(smallest_separation(poor), 0.35 * packed) << n;
  }
}

TEST(Patterns, SeparationIsThatOfBruteForce) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = random_points(2 + static_cast<int>(seed) * 9, seed);
    EXPECT_NEAR(smallest_separation(points), brute_force_separation(points), 1e-12);
  }
  EXPECT_TRUE(std::isinf(smallest_separation({Vec2(0.5f)})));
}

}  // namespace
}  // namespace lambert
