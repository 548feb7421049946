#include "lambert/light/light_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

SpotLight spot(SpotLight::Falloff falloff) {
  SpotLight s;
  s.intensity = Rgb(3);
  s.cos_inner = std::cos(0.3f), s.cos_outer = std::cos(0.9f);
  s.falloff = falloff;
  return s;
}

/// Intensity towards an angle from the axis.
float intensity(const SpotLight& light, float theta) {
  const auto s = light.sample({}, Vec3(std::sin(theta), 0, -std::cos(theta)), Vec2(0));
  return s ? s->radiance.g : 0;
}

// KHR_lights_punctual: attenuation = saturate((cos θ - cos outer) / (cos inner - cos outer))²
TEST(SpotLight, FollowsTheGltfRamp) {
  const SpotLight light = spot(SpotLight::Falloff::gltf);
  EXPECT_FLOAT_EQ(intensity(light, 0.1f), 3);
  EXPECT_FLOAT_EQ(intensity(light, 1.0f), 0);
  const float ramp = (std::cos(0.6f) - std::cos(0.9f)) / (std::cos(0.3f) - std::cos(0.9f));
  EXPECT_NEAR(intensity(light, 0.6f), 3 * ramp * ramp, 1e-5f);
}

TEST(SpotLight, FollowsPbrtsSmoothStep) {
  const SpotLight light = spot(SpotLight::Falloff::smoothstep);
  const float t = (std::cos(0.6f) - std::cos(0.9f)) / (std::cos(0.3f) - std::cos(0.9f));
  EXPECT_NEAR(intensity(light, 0.6f), 3 * t * t * (3 - 2 * t), 1e-5f);
  EXPECT_FLOAT_EQ(intensity(light, 0.2f), 3);
}

TEST(SpotLight, MayHaveASharpEdge) {
  SpotLight light = spot(SpotLight::Falloff::gltf);
  light.cos_inner = light.cos_outer;
  EXPECT_FLOAT_EQ(intensity(light, 0.89f), 3);
  EXPECT_FLOAT_EQ(intensity(light, 0.91f), 0);
}

TEST(SpotLight, PowerIsTheIntegralOfItsIntensity) {
  for (const auto falloff : {SpotLight::Falloff::gltf, SpotLight::Falloff::smoothstep}) {
    const SpotLight light = spot(falloff);
    constexpr int n = 4000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const float cos = -1 + 2 * (static_cast<float>(i) + 0.5f) / n;
      sum += static_cast<double>(intensity(light, std::acos(cos))) * 2 / n;
    }
    EXPECT_NEAR(static_cast<double>(light.bounds({}).power), 2 * static_cast<double>(pi) * sum, 0.01);
  }
}

}  // namespace
}  // namespace lambert
