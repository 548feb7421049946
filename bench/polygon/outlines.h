#pragma once
/// Rings for the benchmarks, the same in every run.

#include "lambert/polygon/test_polygons.h"

#include <cmath>
#include <numbers>
#include <random>

namespace lambert::polygon {

/// About a unit circle with bays in bays, each octave half as deep: a coast whose edges are short.
inline Ring coast(std::size_t n) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  std::vector<double> radius(n, 1);
  for (std::size_t waves = 3; waves < n / 4; waves *= 2) {
    const double shift = phase(random), depth = 0.5 / static_cast<double>(waves);
    for (std::size_t i = 0; i < n; ++i)
      radius[i] +=
          depth * std::sin(2 * std::numbers::pi * static_cast<double>(i * waves % n) / static_cast<double>(n) + shift);
  }
  Ring ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    ring.emplace_back(radius[i] * std::cos(angle), radius[i] * std::sin(angle));
  }
  return ring;
}

/// Needles all round, the hard case.
inline Ring needles(std::size_t n) {
  test::Random random(2);
  return test::star(random, n, 0.5);
}

}  // namespace lambert::polygon
