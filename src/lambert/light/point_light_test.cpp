#include "lambert/light/light_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

// rows: PT-27
TEST(PointLight, IrradianceFallsWithTheSquareOfTheDistance) {
  const PointLight light{{0, 2, 0}, Rgb(8)};
  EXPECT_NEAR(irradiance(light, {}, {0, 0, 0}, {0, 1, 0}, 1), 8.0 / 4, 1e-6);
  EXPECT_NEAR(irradiance(light, {}, {0, -2, 0}, {0, 1, 0}, 1), 8.0 / 16, 1e-6);
  // At 45° and distance 2√2: 8 / 8 · cos 45°
  EXPECT_NEAR(irradiance(light, {}, {2, 0, 0}, {0, 1, 0}, 1), std::sqrt(0.5), 1e-6);
}

TEST(PointLight, GivesNothingAtItsOwnPlace) { EXPECT_FALSE(PointLight{}.sample({}, Vec3(0), Vec2(0.5f))); }

TEST(PointLight, PowerIsIntensityTimesTheSphere) {
  const LightBounds b = PointLight{{1, 2, 3}, Rgb(2)}.bounds({});
  EXPECT_FLOAT_EQ(b.power, 8 * pi);
  EXPECT_EQ(b.box.centre(), Vec3(1, 2, 3));
}

}  // namespace
}  // namespace lambert
