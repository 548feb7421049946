#pragma once
/// One number a pixel, for what looks at one channel at a time, and loops over its rows.

#include "lambert/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace lambert {

/// Rows from the top.
struct Plane {
  Plane() = default;
  Plane(int w, int h, float value = 0)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}
  int width = 0, height = 0;
  std::vector<float> values;

  std::span<float> row(int y) { return std::span(values).subspan(offset(y), static_cast<std::size_t>(width)); }
  std::span<const float> row(int y) const {
    return std::span(values).subspan(offset(y), static_cast<std::size_t>(width));
  }
  float& at(int x, int y) { return values[offset(y) + static_cast<std::size_t>(x)]; }
  float at(int x, int y) const { return values[offset(y) + static_cast<std::size_t>(x)]; }

 private:
  std::size_t offset(int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

/// Rows that are worked on together: enough to be worth a task.
inline constexpr int rows_in_a_block = 16;
inline int row_blocks(int height) { return (height + rows_in_a_block - 1) / rows_in_a_block; }

/// Calls body(block, first, last) for the blocks of rows [first, last) of an image, in parallel.
template <class Body>
void for_row_blocks(int height, const Body& body) {
  parallel_for(static_cast<std::size_t>(row_blocks(height)), [&](std::size_t block) {
    const int first = static_cast<int>(block) * rows_in_a_block;
    body(block, first, std::min(first + rows_in_a_block, height));
  });
}

/// Calls body(y) for every row, in parallel.
template <class Body>
void for_rows(int height, const Body& body) {
  for_row_blocks(height, [&](std::size_t, int first, int last) {
    for (int y = first; y < last; ++y) body(y);
  });
}

/// Correlation with the separable kernel across(x) down(y), both of odd length; the border is repeated outwards.
Plane filtered(const Plane& plane, std::span<const double> across, std::span<const double> down);

/// The greatest less the least value in the square of (2 radius + 1)² pixels around each, within the plane.
Plane range_around(const Plane& plane, int radius);

/// The Gaussian of standard deviation `sigma` pixels (filter/blur.h); the border is repeated outwards.
Plane gaussian_blurred(const Plane& plane, float sigma);

}  // namespace lambert
