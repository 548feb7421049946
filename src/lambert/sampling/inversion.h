#pragma once
/// Sampling by inversion (row PT-14) where the cumulative distribution has no inverse in closed form. Where it has one,
/// use that (warp.h); where it is a table, distribution.h.

namespace lambert {

/// P⁻¹(u): the x in [low, high] at which `cdf`, which must not decrease, goes from at most u to above it. By bisection,
/// for u in [0,1): exact to (high - low) / 2^53 or a unit in the last place of x, after at most 53 evaluations.
template <class Cdf>
double invert_cdf(const Cdf& cdf, double u, double low, double high) {
  for (int i = 0; i < 53; ++i) {
    const double middle = low + 0.5 * (high - low);
    if (middle <= low || middle >= high) break;
    (cdf(middle) <= u ? low : high) = middle;
  }
  return low;
}

}  // namespace lambert
