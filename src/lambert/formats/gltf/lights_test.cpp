#include "lambert/formats/gltf/lights.h"

#include "lambert/formats/gltf/gltf_test_tools.h"

#include <cmath>

namespace lambert::gltf {
namespace {

TestDocument with_light(std::string_view light) {
  TestDocument d;
  d.set("nodes", R"([{"translation": [1, 2, 3], "rotation": [-0.70710678, 0, 0, 0.70710678],
      "extensions": {"KHR_lights_punctual": {"light": 0}}}])");
  d.set("extensions", R"({"KHR_lights_punctual": {"lights": [)" + std::string(light) + "]}}");
  return d;
}
template <class T>
T light(std::string_view json) {
  return std::get<T>(read(with_light(json)).lights().at(0));
}

TEST(GltfLights, PointLightsAreInCandela) {
  const auto point = light<PointLight>(R"({"type": "point", "intensity": 683, "color": [1, 0.5, 0.25], "range": 9})");
  expect_near(point.position, {1, 2, 3});
  expect_near(point.intensity, Rgb(1, 0.5f, 0.25f));
  EXPECT_TRUE(has_note(notes_of(with_light(R"({"type": "point", "range": 9})")), "range of glTF lights"));
}

TEST(GltfLights, DirectionalLightsAreInLux) {
  const auto sun = light<DirectionalLight>(R"({"type": "directional", "intensity": 1366})");
  expect_near(sun.irradiance, Rgb(2.0f));
  expect_near(sun.direction, {0, -1, 0});  // the node turns -z down
}

TEST(GltfLights, SpotsHaveTwoCones) {
  const auto spot = light<SpotLight>(
      R"({"type": "spot", "intensity": 683, "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}})");
  EXPECT_NEAR(spot.cos_inner, std::cos(0.25f), 1e-6f);
  EXPECT_NEAR(spot.cos_outer, std::cos(0.5f), 1e-6f);
  EXPECT_EQ(spot.falloff, SpotLight::Falloff::gltf);
  expect_near(spot.direction, {0, -1, 0});
  EXPECT_NEAR(light<SpotLight>(R"({"type": "spot"})").cos_outer, std::sqrt(0.5f), 1e-6f);
}

TEST(GltfLights, BlackOnesAreLeftOut) {
  EXPECT_TRUE(read(with_light(R"({"type": "point", "intensity": 0})")).lights().empty());
  EXPECT_TRUE(read(with_light(R"({"type": "point", "color": [0, 0, 0]})")).lights().empty());
}

TEST(GltfLights, ImpossibleLightsAreRefused) {
  EXPECT_NE(refusal(with_light(R"({"type": "pont"})"))
                .find("/extensions/KHR_lights_punctual/lights/0/type: unknown light 'pont'; did you mean 'point'?"),
            std::string::npos);
  EXPECT_NE(refusal(with_light(R"({"type": "spot", "spot": {"innerConeAngle": 1, "outerConeAngle": 0.5}})"))
                .find("/spot: expected 0 <= innerConeAngle"),
            std::string::npos);
  TestDocument d = with_light(R"({"type": "point"})");
  d["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 1;
  EXPECT_NE(refusal(d).find("refers to 1 of lights, but there are 1"), std::string::npos);
}

}  // namespace
}  // namespace lambert::gltf
