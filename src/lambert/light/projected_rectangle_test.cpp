#include "lambert/light/projected_rectangle.h"

#include <gtest/gtest.h>

#include <array>

namespace lambert {
namespace {

/// Solid angle of [0, x] × [0, y] at unit distance, with sign.
double corner_solid_angle(double x, double y) { return std::atan(x * y / std::sqrt(1 + x * x + y * y)); }
double exact_solid_angle(double x0, double y0, double x1, double y1) {
  return corner_solid_angle(x1, y1) - corner_solid_angle(x0, y1) - corner_solid_angle(x1, y0) +
         corner_solid_angle(x0, y0);
}

struct Case {
  Vec2 corner, size;
};
constexpr std::array cases = {Case{{-0.5f, -0.5f}, {1, 1}}, Case{{-0.1f, -0.1f}, {0.2f, 0.15f}},
                              Case{{3, 2}, {1, 1}},         Case{{-40, -30}, {80, 60}},
                              Case{{-20, -20}, {10, 10}},   Case{{10, 10}, {10, 8}},
                              Case{{-500, -1}, {1000, 900}}};

TEST(ProjectedRectangle, HasTheSolidAngleOfItsFourCorners) {
  for (const auto& [c, s] : cases) {
    const double x1 = static_cast<double>(c.x + s.x), y1 = static_cast<double>(c.y + s.y);
    const double exact = exact_solid_angle(static_cast<double>(c.x), static_cast<double>(c.y), x1, y1);
    EXPECT_NEAR(static_cast<double>(ProjectedRectangle(c, s).solid_angle()) / exact, 1, 1e-5) << c.x;
  }
}

TEST(ProjectedRectangle, CubeFacesAndOctants) {
  EXPECT_NEAR(ProjectedRectangle({-1, -1}, {2, 2}).solid_angle(), 4 * pi / 6, 2e-6f);
  EXPECT_NEAR(ProjectedRectangle({0, 0}, {1, 1}).solid_angle(), 4 * pi / 24, 1e-6f);
  EXPECT_NEAR(ProjectedRectangle({0, 0}, {900, 900}).solid_angle(), pi / 2, 3e-3f) << "an octant but for a rim";
}

// Left of a sample lies the part u.x of the solid angle, and on its column below it the part u.y.
TEST(ProjectedRectangle, CutsTheSolidAngleIntoEqualParts) {
  for (const auto& [c, s] : cases) {
    const ProjectedRectangle r(c, s);
    const double x0 = static_cast<double>(c.x), y0 = static_cast<double>(c.y);
    const double y1 = static_cast<double>(c.y + s.y);
    const double exact = exact_solid_angle(x0, y0, static_cast<double>(c.x + s.x), y1);
    for (int i = 0; i <= 20; ++i) {
      const Vec2 u(std::min(static_cast<float>(i) / 20, one_minus_epsilon), 0.3f);
      const Vec2 place = r.sample(u) / s;
      ASSERT_GE(place.x, 0);
      ASSERT_LE(place.x, 1);
      const double x = x0 + static_cast<double>(place.x * s.x), y = y0 + static_cast<double>(place.y * s.y);
      EXPECT_NEAR(exact_solid_angle(x0, y0, x, y1) / exact, static_cast<double>(u.x), 2e-4) << c.x;
      const auto height = [&](double v) { return v / std::sqrt(1 + x * x + v * v); };
      EXPECT_NEAR((height(y) - height(y0)) / (height(y1) - height(y0)), 0.3, 1e-3) << c.x;
    }
  }
}

}  // namespace
}  // namespace lambert
