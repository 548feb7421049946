#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

namespace lambert {

struct Roots {
  double near = 0, far = 0;
};

/// Real roots of a t² + 2 b t + c in order, without cancellation (Press et al., "Numerical Recipes", 5.6); none if
/// complex, a = 0 or anything is NaN. `discriminant` is b² - a c, which the caller may know more exactly.
inline std::optional<Roots> solve_half_quadratic(double a, double b, double c, double discriminant) {
  if (!(discriminant >= 0) || a == 0) return std::nullopt;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double t0 = q / a, t1 = q != 0 ? c / q : t0;
  return Roots{std::min(t0, t1), std::max(t0, t1)};
}

}  // namespace lambert
