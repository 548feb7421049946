#pragma once
#include "lambert/image/image.h"

#include <span>
#include <vector>

namespace lambert::compare {

/// One value a pixel, rows from the top.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;

  Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  std::span<float> row(int y) { return {&values[offset(y)], static_cast<std::size_t>(width)}; }
  std::span<const float> row(int y) const { return {&values[offset(y)], static_cast<std::size_t>(width)}; }

 private:
  std::size_t offset(int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

/// Correlation with the separable kernel across(x) down(y), both of odd length; the border is repeated outwards.
Plane filtered(const Plane& plane, std::span<const float> across, std::span<const float> down);

/// f(x) for x = -radius … radius.
template <class F>
std::vector<float> tabulated(int radius, F f) {
  std::vector<float> kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(static_cast<float>(f(static_cast<double>(x))));
  return kernel;
}

}  // namespace lambert::compare
