#include "lambert/image/compare/z_scores.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambert::compare {
namespace {

/// P(|N(0,1)| > z)
double two_sided(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

/// That the largest of n independent ones is as extreme: 1 - (1 - p)^n, exact also for tiny p.
double of_any(double p, double n) { return p < 1 ? -std::expm1(n * std::log1p(-p)) : 1; }

/// A chi-square value of n degrees of freedom as a standard normal one (Wilson and Hilferty 1931).
double chi_square_z(double value, double n) {
  const double k = 2 / (9 * n);
  return (std::cbrt(value / n) - (1 - k)) / std::sqrt(k);
}

}  // namespace

bool ZTest::same(double alpha) const {
  const double each = -std::expm1(std::log1p(-alpha) / 3);
  return certain == 0 && p_largest > each && p_mean > each && p_spread > each;
}

ZTest z_test(const Image& a, const Image& b) {
  if (a.width() != b.width() || a.height() != b.height()) throw Error("the sizes differ");
  const auto variance_a = a.channel("variance.Y"), variance_b = b.channel("variance.Y");
  if (!variance_a && !variance_b)
    throw Error("neither image has the channel variance.Y that a z-test needs: render with --aov variance to .exr");
  ZTest test{.map = Plane(a.width(), a.height())};
  double differences = 0, variances = 0, squares = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const auto variance = [&](const Image& image, const std::optional<std::size_t>& channel) {
        return channel ? std::max(0.0, static_cast<double>(image.at(x, y, *channel))) : 0.0;
      };
      const double v = variance(a, variance_a) + variance(b, variance_b);
      const double difference =
          static_cast<double>(luminance(a.rgb(x, y))) - static_cast<double>(luminance(b.rgb(x, y)));
      if (!(v > 0)) {
        if (difference != 0) ++test.certain;
        continue;
      }
      const double z = std::isfinite(difference) ? difference / std::sqrt(v) : std::numeric_limits<double>::max();
      ++test.pixels;
      differences += std::isfinite(difference) ? difference : 0;
      variances += v;
      squares += z * z;
      test.map.row(y)[static_cast<std::size_t>(x)] = static_cast<float>(z);
      if (std::abs(z) > test.largest) test.largest = std::abs(z), test.x = x, test.y = y;
    }
  if (test.pixels == 0) return test;
  const auto n = static_cast<double>(test.pixels);
  test.p_largest = of_any(two_sided(test.largest), n);
  test.mean_z = differences / std::sqrt(variances);
  test.p_mean = two_sided(test.mean_z);
  const double spread = chi_square_z(squares, n);
  test.p_spread = 0.5 * std::erfc(spread / std::sqrt(2.0));
  return test;
}

}  // namespace lambert::compare
