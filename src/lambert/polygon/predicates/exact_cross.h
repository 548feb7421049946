#pragma once
/// What exact decisions on points are made of: cross products, rounded with a bound of their error, and as expansions.

#include "lambert/base/vec.h"
#include "lambert/polygon/predicates/expansion.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace lambert::polygon {

struct RoundedCross {
  double value;
  double size;  ///< the sum of the sizes of both products; value is off by at most 4.1 units of it, and 2^-1073
};

/// (b - a) x (d - c).
inline RoundedCross rounded_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double left = (b.x - a.x) * (d.y - c.y), right = (b.y - a.y) * (d.x - c.x);
  return {left - right, std::abs(left) + std::abs(right)};
}

template <class Real>
Expansion<2, Real> exact_difference(double a, double b) {
  return Expansion<2, Real>(two_sum<Real>(static_cast<Real>(a), -static_cast<Real>(b)));
}

template <class Real>
Expansion<16, Real> exact_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  return exact_difference<Real>(b.x, a.x) * exact_difference<Real>(d.y, c.y) -
         exact_difference<Real>(b.y, a.y) * exact_difference<Real>(d.x, c.x);
}

/// Numbers in which products of up to six differences of any finite doubles, with all their roundings, have their
/// place.
using WideReal = long double;
static_assert(std::numeric_limits<WideReal>::max_exponent >= 16384 &&
                  std::numeric_limits<WideReal>::min_exponent <= -16381,
              "exact decisions at extreme sizes need a long double with an exponent of 15 bits");

/// 2^exponent, from -1022 to 1023.
constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Whether products of `degree` differences of these coordinates, with all their roundings, are doubles.
template <int degree>
bool products_fit(std::initializer_list<Vec2d> points) {
  // Coordinates are multiples of 2^-52 of the least, and so are their differences; the products are multiples of the
  // least double.
  constexpr double least = power_of_two(53 - 1074 / degree), most = power_of_two(1000 / degree - 2);
  bool fit = true;
  for (const Vec2d p : points)
    for (const double size : {std::abs(p.x), std::abs(p.y)})
      fit = fit && (size == 0 || (size >= least && size <= most));
  return fit;
}

/// decide(Real()) with the type of the numbers in which to reckon: doubles where products of `degree` differences of
/// the points' coordinates fit, else wider ones.
template <int degree, class Decide>
int decide_exactly(std::initializer_list<Vec2d> points, const Decide& decide) {
  return products_fit<degree>(points) ? decide(double()) : decide(WideReal());
}

}  // namespace lambert::polygon
