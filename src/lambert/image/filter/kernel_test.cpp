#include "lambert/image/filter/kernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lambert {
namespace {

// Σ k(x - i) over the integers is 1 for every x: constants pass unchanged.
TEST(Kernel, PartitionOfUnity) {
  for (double x = 0.013; x < 1; x += 0.07) {
    double box = 0, triangle = 0, mitchell = 0, catmull_rom = 0, b_spline = 0;
    for (int i = -4; i <= 4; ++i) {
      box += box_kernel(x - i, 0.5);
      triangle += triangle_kernel(x - i, 1);
      mitchell += cubic_kernel(x - i, 1.0 / 3, 1.0 / 3);
      catmull_rom += cubic_kernel(x - i, 0, 0.5);
      b_spline += cubic_kernel(x - i, 1, 0);
    }
    for (const double sum : {box, triangle, mitchell, catmull_rom, b_spline}) EXPECT_NEAR(sum, 1, 1e-12) << x;
  }
}

TEST(Kernel, InterpolatingKernelsAreOneAndZeroAtTheIntegers) {
  for (int i = -4; i <= 4; ++i) {
    const double expected = i == 0;
    EXPECT_NEAR(triangle_kernel(i, 1), expected, 1e-12);
    EXPECT_NEAR(cubic_kernel(i, 0, 0.5), expected, 1e-12);
    EXPECT_NEAR(lanczos_kernel(i, 3), expected, 1e-12);
  }
}

TEST(Kernel, EvenAndZeroBeyondTheRadius) {
  for (const std::string& name : filter_names()) {
    const Kernel k({.kind = filter_kind(name)}, Kernel::Axis::x);
    for (double x = 0; x < 4; x += 0.11) {
      EXPECT_EQ(k(x), k(-x)) << name;
      if (x > k.radius()) {
        EXPECT_EQ(k(x), 0) << name;
      }
    }
  }
}

TEST(Kernel, CatmullRomReproducesParabolas) {
  for (double x = 0.03; x < 1; x += 0.09) {
    double sum = 0;
    for (int i = -3; i <= 4; ++i) sum += cubic_kernel(x - i, 0, 0.5) * (2 * i * i - 3 * i + 1);
    EXPECT_NEAR(sum, 2 * x * x - 3 * x + 1, 1e-12);
  }
}

TEST(Kernel, TheGaussianEndsAtZeroUnlessTruncated) {
  const Kernel lowered({.kind = FilterKind::gaussian}, Kernel::Axis::x);
  const Kernel truncated({.kind = FilterKind::gaussian, .truncated = true}, Kernel::Axis::x);
  EXPECT_NEAR(lowered(1.5), 0, 1e-12);
  EXPECT_NEAR(truncated(1.5), std::exp(-4.5), 1e-12);
  EXPECT_NEAR(lowered(0), 1 - std::exp(-4.5), 1e-12);
}

TEST(Kernel, BartlettIsTheTriangle) { EXPECT_EQ(filter_kind("bartlett"), FilterKind::triangle); }

}  // namespace
}  // namespace lambert
