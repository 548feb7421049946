#pragma once
/// Linear interpolation of anything that can be added and scaled: numbers, points of the plane and of space.

#include <cstddef>
#include <vector>

namespace lambert::polygon {

/// a (1 - t) + b t: exactly a at t = 0 and b at t = 1, for finite values (PG-08, first form). Two multiplications.
template <class T>
T weighted(const T& a, const T& b, double t) {
  return a * (1 - t) + b * t;
}

/// a + (b - a) t: exactly a at t = 0, and b at t = 1 (PG-08, second form; the sum alone could miss b by a rounding).
template <class T>
T lerp(const T& a, const T& b, double t) {
  return t == 1 ? b : a + (b - a) * t;
}

/// The n + 1 evenly spaced values from start to end, both included and exact (PG-09); start alone when n = 0.
template <class T>
std::vector<T> parameter_steps(const T& start, const T& end, std::size_t n) {
  std::vector<T> values{start};
  values.reserve(n + 1);
  for (std::size_t i = 1; i <= n; ++i)
    values.push_back(lerp(start, end, static_cast<double>(i) / static_cast<double>(n)));
  return values;
}

}  // namespace lambert::polygon
