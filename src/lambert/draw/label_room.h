#pragma once
#include "lambert/base/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lambert::draw {

/// Rectangles of a sheet that do not overlap, found by a grid of cells.
class Room {
 public:
  explicit Room(double cell) : cell_(cell) {}

  /// Takes the rectangle unless one that was taken overlaps it, or it is not finite.
  bool take(Vec2d min, Vec2d max) {
    const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    if (!(std::abs(min.x) + std::abs(min.y) + std::abs(max.x) + std::abs(max.y) < 1e6)) return false;
    for (std::int64_t y = index(min.y); y <= index(max.y); ++y)
      for (std::int64_t x = index(min.x); x <= index(max.x); ++x)
        for (const auto& [lower, upper] : taken_[y * 4'000'000 + x])
          if (lower.x < max.x && min.x < upper.x && lower.y < max.y && min.y < upper.y) return false;
    for (std::int64_t y = index(min.y); y <= index(max.y); ++y)
      for (std::int64_t x = index(min.x); x <= index(max.x); ++x) taken_[y * 4'000'000 + x].emplace_back(min, max);
    return true;
  }

 private:
  double cell_;
  std::unordered_map<std::int64_t, std::vector<std::pair<Vec2d, Vec2d>>> taken_;
};

}  // namespace lambert::draw
