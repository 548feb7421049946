#include "lambert/light/light_bounds.h"

#include "lambert/light/light_test_tools.h"
#include "lambert/light/many_lights.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

LightBounds facing(Vec3 at, Vec3 axis) {
  LightBounds b;
  b.box.add(at);
  b.axis = axis, b.cos_theta_o = 1, b.cos_theta_e = 0, b.power = 2, b.intensity = 3;
  return b;
}

TEST(LightBounds, AMergeHoldsBothBoxesAndCones) {
  const LightBounds m = merge(facing({0, 0, 0}, {1, 0, 0}), facing({4, 0, 0}, {0, 1, 0}));
  EXPECT_EQ(m.box.max, Vec3(4, 0, 0));
  EXPECT_FLOAT_EQ(m.power, 4);
  EXPECT_FLOAT_EQ(m.intensity, 6);
  EXPECT_NEAR(m.cos_theta_o, std::sqrt(0.5f), 1e-5f);
  EXPECT_NEAR(dot(m.axis, normalize(Vec3(1, 1, 0))), 1, 1e-5f);
}

TEST(LightBounds, OppositeAxesMakeAWholeSphere) {
  EXPECT_FLOAT_EQ(merge(facing({}, {0, 0, 1}), facing({}, {0, 0, -1})).cos_theta_o, -1);
}

TEST(LightBounds, AMergeWithinAConeKeepsTheCone) {
  LightBounds wide = facing({}, {0, 0, 1});
  wide.cos_theta_o = 0;
  EXPECT_FLOAT_EQ(merge(wide, facing({}, normalize(Vec3(1, 0, 1)))).cos_theta_o, 0);
  EXPECT_FLOAT_EQ(merge(facing({}, normalize(Vec3(1, 0, 1))), wide).cos_theta_o, 0);
}

TEST(LightBounds, ImportanceOfASmallLightIsItsIrradiance) {
  const LightBounds b = facing({0, 2, 0}, {0, -1, 0});
  EXPECT_NEAR(importance(b, {0, 0, 0}, {0, 1, 0}), 3.0f / 4, 1e-6f);
  EXPECT_NEAR(importance(b, {2, 0, 0}, {0, 1, 0}), 3.0f / 8 * 0.5f, 1e-5f);
  EXPECT_NEAR(importance(b, {2, 0, 0}, Vec3(0)), 3.0f / 8 * std::sqrt(0.5f), 1e-5f);
  EXPECT_EQ(importance(b, {0, 4, 0}, {0, 1, 0}), 0) << "behind the light";
  LightBounds both = b;
  both.two_sided = true;
  EXPECT_NEAR(importance(both, {0, 4, 0}, {0, 1, 0}), 3.0f / 4, 1e-6f);
}

// The importance of a pair is 0 only where both are: else a light that contributes could never be chosen.
TEST(LightBounds, APairMattersWhereOneOfItDoes) {
  const std::vector<Light> lights = many_lights(60);
  TestNumbers r(3);
  for (int i = 0; i < 20000; ++i) {
    const auto pick = [&] {
      return light_bounds(lights[static_cast<std::size_t>(r.next() * static_cast<float>(lights.size()))], {});
    };
    const LightBounds a = pick(), b = pick();
    const Vec3 p = 12.0f * r.next_in_cube(), n = r.next_direction();
    // Of a light seen edge on rounding may leave a trace.
    const float one = importance(a, p, n);
    if (one > 1e-4f * a.intensity / length_squared(p - a.box.centre())) {
      EXPECT_GT(importance(merge(a, b), p, n), 0);
    }
  }
}

TEST(LightBounds, OrientationMeasureGrowsFromAHemisphereToTheSphere) {
  LightBounds b = facing({}, {0, 0, 1});
  // θ_o = 0, θ_e = π/2: ∫ cos over the hemisphere = π.
  EXPECT_NEAR(orientation_measure(b), pi, 1e-5f);
  b.cos_theta_o = -1;
  EXPECT_NEAR(orientation_measure(b), 4 * pi, 1e-4f);
}

}  // namespace
}  // namespace lambert
