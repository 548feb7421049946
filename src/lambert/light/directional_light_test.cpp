#include "lambert/light/light_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TEST(DirectionalLight, GivesItsIrradianceOnAFacingSurfaceAndTheCosineElsewhere) {
  const DirectionalLight light{normalize(Vec3(0, -1, -1)), Rgb(2)};
  EXPECT_NEAR(irradiance(light, {}, {5, 6, 7}, normalize(Vec3(0, 1, 1)), 1), 2, 1e-5);
  EXPECT_NEAR(irradiance(light, {}, {5, 6, 7}, {0, 1, 0}, 1), 2 * std::sqrt(0.5), 1e-5);
  EXPECT_TRUE(std::isinf(light.sample({}, Vec3(0), Vec2(0))->distance));
}

TEST(DirectionalLight, PowerPassesThroughTheSceneDisk) {
  LightContext context;
  context.scene_bounds.add(Vec3(-1)), context.scene_bounds.add(Vec3(1));
  const LightBounds b = DirectionalLight{{0, -1, 0}, Rgb(2)}.bounds(context);
  EXPECT_NEAR(b.power, 2 * pi * 3, 1e-4f);
  EXPECT_TRUE(b.box.empty());
}

}  // namespace
}  // namespace lambert
