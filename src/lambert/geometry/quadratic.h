#pragma once
#include <cmath>
#include <optional>

namespace lambert {

struct Roots {
  double near = 0, far = 0;
};

/// Real roots of a t² + 2 b t + c in order, without cancellation (Press et al., "Numerical Recipes", 5.6); none if
/// complex or a = 0.
inline std::optional<Roots> solve_half_quadratic(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0) || a == 0) return std::nullopt;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0) return Roots{0, 0};
  const double t0 = q / a, t1 = c / q;
  return t0 < t1 ? Roots{t0, t1} : Roots{t1, t0};
}

}  // namespace lambert
