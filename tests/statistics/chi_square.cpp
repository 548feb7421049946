#include "statistics/chi_square.h"

#include "lambert/base/hash.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

namespace lambert::statistics {
namespace {

/// Q(a, x), the regularised upper incomplete gamma function: series below a + 1, continued fraction above
/// (Press et al., "Numerical Recipes", 6.2).
double upper_gamma(double a, double x) {
  if (x <= 0) return 1;
  const double front = std::exp(-x + a * std::log(x) - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (int n = 1; n < 10000 && std::abs(term) > 1e-15 * std::abs(sum); ++n) sum += term *= x / (a + n);
    return 1 - front * sum;
  }
  constexpr double tiny = 1e-300;
  double b = x + 1 - a, c = 1 / tiny, d = 1 / b, h = d;
  for (int n = 1; n < 10000; ++n) {
    const double an = -n * (n - a);
    b += 2;
    d = an * d + b, c = b + an / c;
    d = 1 / (std::abs(d) < tiny ? tiny : d), c = std::abs(c) < tiny ? tiny : c;
    h *= d * c;
    if (std::abs(d * c - 1) < 1e-15) break;
  }
  return front * h;
}

TestResult judged(double p_value, double statistic, int degrees, int tests) {
  TestResult r{p_value, statistic, degrees, p_value >= sidak(significance, tests), {}};
  std::ostringstream text;
  text << "p = " << p_value << " (level " << sidak(significance, tests) << "), statistic " << statistic << ", "
       << degrees << " degrees of freedom";
  r.message = text.str();
  return r;
}

Vec2 random_square(int i) {
  const std::uint64_t h = hash_values(i, 0x5eed);
  return {hash_to_float(h), hash_to_float(h << 24)};
}

/// The mean of f over [0,1]² by the midpoints of n by n cells.
template <class F>
double midpoint_mean(int n, const F& f) {
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) sum += f((i + 0.5) / n, (j + 0.5) / n);
  return sum / (n * n);
}

int bin_of(double x, int bins) { return std::clamp(static_cast<int>(x * bins), 0, bins - 1); }

}  // namespace

double chi_square_survival(double statistic, int degrees) { return upper_gamma(0.5 * degrees, 0.5 * statistic); }
double sidak(double level, int tests) { return 1 - std::pow(1 - level, 1.0 / tests); }

TestResult chi_square(std::span<const double> observed, std::span<const double> expected, int tests) {
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  const double total = std::accumulate(observed.begin(), observed.end(), 0.0);
  double statistic = 0, pooled_observed = 0, pooled_expected = 0;
  int cells = 0;
  for (const std::size_t i : order) {
    // Nothing expected: a thousandth of the samples there is an error of the density, less is that of its integral.
    if (expected[i] <= 0 && observed[i] > 1e-3 * total) {
      TestResult r = judged(0, observed[i], 1, tests);
      r.message = "cell " + std::to_string(i) + " has " + std::to_string(observed[i]) + " samples where none can be";
      return r;
    }
    pooled_observed += observed[i], pooled_expected += expected[i];
    if (pooled_expected < 5) continue;
    const double d = pooled_observed - pooled_expected;
    statistic += d * d / pooled_expected;
    pooled_observed = pooled_expected = 0;
    ++cells;
  }
  const int degrees = std::max(1, cells - 1);
  return judged(chi_square_survival(statistic, degrees), statistic, degrees, tests);
}

TestResult chi_square_sphere(const std::function<std::optional<Vec3>(Vec2, float)>& sample,
                             const std::function<double(Vec3)>& pdf, const SphereTest& s) {
  const auto cells = static_cast<std::size_t>(s.polar_bins) * static_cast<std::size_t>(s.azimuth_bins);
  std::vector<double> observed(cells + 1), expected(cells + 1);
  for (int i = 0; i < s.samples; ++i) {
    const auto w = sample(random_square(i), hash_to_float(hash_values(i, 0x10be)));
    if (!w) {
      ++observed[cells];
      continue;
    }
    const double z = 0.5 * (static_cast<double>(w->z) + 1);
    double turn = std::atan2(static_cast<double>(w->y), static_cast<double>(w->x)) / (2 * std::numbers::pi);
    if (turn < 0) turn += 1;
    ++observed[static_cast<std::size_t>(bin_of(z, s.polar_bins) * s.azimuth_bins + bin_of(turn, s.azimuth_bins))];
  }
  // Bins are equal in z and in azimuth, hence in solid angle.
  double total = 0;
  for (int p = 0; p < s.polar_bins; ++p)
    for (int a = 0; a < s.azimuth_bins; ++a) {
      const double mean = midpoint_mean(s.subdivisions, [&](double x, double y) {
        const double z = 2 * (p + y) / s.polar_bins - 1, phi = 2 * std::numbers::pi * (a + x) / s.azimuth_bins;
        const double ring = std::sqrt(std::max(0.0, 1 - z * z));
        return pdf(Vec3(Vec3d(ring * std::cos(phi), ring * std::sin(phi), z)));
      });
      const double share = mean * 4 * std::numbers::pi / static_cast<double>(cells);
      expected[static_cast<std::size_t>(p * s.azimuth_bins + a)] = share * s.samples;
      total += share;
    }
  expected[cells] = std::max(0.0, 1 - total) * s.samples;
  TestResult r = chi_square(observed, expected, s.tests);
  r.message += ", density integrates to " + std::to_string(total);
  return r;
}

TestResult chi_square_square(const std::function<Vec2(Vec2)>& sample, const std::function<double(Vec2)>& pdf,
                             const SphereTest& s) {
  const auto cells = static_cast<std::size_t>(s.polar_bins) * static_cast<std::size_t>(s.azimuth_bins);
  std::vector<double> observed(cells), expected(cells);
  for (int i = 0; i < s.samples; ++i) {
    const Vec2 p = sample(random_square(i));
    const int row = bin_of(static_cast<double>(p.y), s.polar_bins),
              column = bin_of(static_cast<double>(p.x), s.azimuth_bins);
    ++observed[static_cast<std::size_t>(row * s.azimuth_bins + column)];
  }
  for (int j = 0; j < s.polar_bins; ++j)
    for (int i = 0; i < s.azimuth_bins; ++i) {
      const double mean = midpoint_mean(s.subdivisions, [&](double x, double y) {
        return pdf(Vec2(Vec2d((i + x) / s.azimuth_bins, (j + y) / s.polar_bins)));
      });
      expected[static_cast<std::size_t>(j * s.azimuth_bins + i)] = mean * s.samples / static_cast<double>(cells);
    }
  return chi_square(observed, expected, s.tests);
}

TestResult z_test(double mean, double standard_error, double expected, int tests) {
  const double z = standard_error > 0 ? std::abs(mean - expected) / standard_error : (mean == expected ? 0.0 : 1e9);
  return judged(std::erfc(z / std::numbers::sqrt2), z, 1, tests);
}

double jacobian_error(const std::function<Vec3(Vec2)>& map, const std::function<double(Vec3)>& pdf, int side) {
  constexpr float step = 1e-3f;
  double largest = 0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const Vec2 u((static_cast<float>(i) + 0.37f) / static_cast<float>(side),
                   (static_cast<float>(j) + 0.61f) / static_cast<float>(side));
      const Vec3d du(map(u + Vec2(step, 0)) - map(u - Vec2(step, 0))),
          dv(map(u + Vec2(0, step)) - map(u - Vec2(0, step)));
      const double area =
          glm::length(glm::cross(du, dv)) / (4.0 * static_cast<double>(step) * static_cast<double>(step));
      largest = std::max(largest, std::abs(pdf(map(u)) * area - 1));
    }
  return largest;
}

}  // namespace lambert::statistics
