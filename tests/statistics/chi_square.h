#pragma once
/// Statistical tests that decide whether sampling code does what its density says.
///
/// A test passes when its p-value is at least the significance level; with `tests` made together the level is corrected
/// so that the chance of any false alarm stays the same (Šidák 1967).

#include "lambert/base/vec.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace lambert::statistics {

inline constexpr double significance = 0.01;

struct TestResult {
  double p_value = 0;
  double statistic = 0;
  int degrees_of_freedom = 0;
  bool passed = false;
  std::string message;  ///< for failure messages
  explicit operator bool() const { return passed; }
};

/// The probability that a chi-square variable of `degrees` exceeds `statistic`.
double chi_square_survival(double statistic, int degrees);
double sidak(double level, int tests);

/// Observed counts against expected ones (of about the same sum). Cells that expect fewer than 5 are pooled; a count
/// where nothing is expected fails at once.
TestResult chi_square(std::span<const double> observed, std::span<const double> expected, int tests = 1);

struct SphereTest {
  int samples = 100000;
  int polar_bins = 21, azimuth_bins = 41;  ///< odd, so that hemisphere boundaries do not hide on bin edges
  int subdivisions = 8;                    ///< of each bin and axis, for the integral of the density
  int tests = 1;
};

/// Directions drawn from hashed random numbers against a density in solid angle. A sample of none is counted as a share
/// that the density leaves out: its integral may be below 1 by as much.
TestResult chi_square_sphere(const std::function<std::optional<Vec3>(Vec2 u, float u_lobe)>& sample,
                             const std::function<double(Vec3)>& pdf, const SphereTest& settings = {});

/// Points of [0,1]² against a density over it.
TestResult chi_square_square(const std::function<Vec2(Vec2 u)>& sample, const std::function<double(Vec2)>& pdf,
                             const SphereTest& settings = {});

/// Whether a mean of independent values is `expected`: two-sided z-test.
TestResult z_test(double mean, double standard_error, double expected, int tests = 1);

/// The largest relative difference between pdf and 1 / |∂w/∂u × ∂w/∂v| of a map from the square to directions, over a
/// grid of `side`² points; points where the density changes too fast for the step are left out by the caller's choice
/// of map.
double jacobian_error(const std::function<Vec3(Vec2)>& map, const std::function<double(Vec3)>& pdf, int side = 20);

}  // namespace lambert::statistics
