#include "lambert/formats/pbrt/pbrt_test_tools.h"

#include "lambert/image/io.h"

#include <cmath>

namespace lambert {
namespace {

template <class L>
L light_of(const std::string& world) {
  const SceneGraph graph = read_whole_world(world);
  return std::get<L>(graph.lights().at(0));
}

TEST(PbrtLights, Point) {
  const auto light = light_of<PointLight>("Translate 1 0 0 LightSource \"point\" \"point3 from\" [ 0 2 0 ]");
  expect_near(light.position, {1, 2, 0});
  // Power is divided by the 4π of a unit intensity.
  expect_near(light_of<PointLight>("LightSource \"point\" \"float power\" 100").intensity, Rgb(100 / (4 * pi)), 1e-4f);
}

TEST(PbrtLights, Spot) {
  const auto light = light_of<SpotLight>(
      "Scale 2 2 2 LightSource \"spot\" \"point3 from\" [ 1 0 0 ] \"point3 to\" [ 1 -3 0 ] \"float coneangle\" 40 "
      "\"float conedeltaangle\" 10 \"rgb I\" [ 2 2 2 ]");
  expect_near(light.position, {2, 0, 0});
  expect_near(light.direction, {0, -1, 0});
  EXPECT_NEAR(light.cos_outer, std::cos(40 * pi / 180), 1e-6f);
  EXPECT_NEAR(light.cos_inner, std::cos(30 * pi / 180), 1e-6f);
  EXPECT_EQ(light.falloff, SpotLight::Falloff::smoothstep);
  EXPECT_EQ(light.intensity, Rgb(2));
  const float a = std::cos(25 * pi / 180), b = std::cos(30 * pi / 180);
  expect_near(light_of<SpotLight>("LightSource \"spot\" \"float power\" 10").intensity,
              Rgb(10 / (2 * pi * (1 - a + (a - b) / 2))), 1e-3f);
}

TEST(PbrtLights, Distant) {
  const auto light = light_of<DirectionalLight>(
      "LightSource \"distant\" \"point3 from\" [ 0 5 0 ] \"point3 to\" [ 0 0 0 ] \"rgb L\" [ 1 2 3 ] \"float scale\" 2 "
      "\"float illuminance\" 10");
  expect_near(light.direction, {0, -1, 0});
  expect_near(light.irradiance, Rgb(20, 40, 60));
  EXPECT_NE(error_of([] { read_world("LightSource \"distant\" \"point3 to\" [ 0 0 0 ]"); }).find("the same point"),
            std::string::npos);
}

TEST(PbrtLights, InfiniteConstant) {
  const auto light = light_of<EnvironmentLight>("LightSource \"infinite\" \"rgb L\" [ 1 2 3 ] \"float scale\" 2");
  expect_near(light.radiance(Vec3(0, 0, 1)), Rgb(2, 4, 6));
  expect_near(light_of<EnvironmentLight>("LightSource \"infinite\" \"float illuminance\" 1").radiance(Vec3(0, 1, 0)),
              Rgb(1 / pi));
}

// In pbrt's equal-area map the centre of the square is +z and its corners are -z.
TEST(PbrtLights, InfiniteEqualAreaImageTurnsWithTheTransformation) {
  const TemporaryFolder folder;
  Image image(16, 16, rgb_channels());
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) image.set_rgb(x, y, std::abs(x - 7.5) < 3 && std::abs(y - 7.5) < 3 ? Rgb(4) : Rgb(1));
  }
  write_image(folder.path() / "sky.pfm", image);
  Notes notes;
  const std::string light = "LightSource \"infinite\" \"string filename\" \"sky.pfm\" \"float scale\" .5";
  const SceneGraph upright = read_world(light, notes, "", folder.path());
  const auto& l = std::get<EnvironmentLight>(upright.lights().at(0));
  expect_near(l.radiance(Vec3(0, 0, 1)), Rgb(2), 1e-4f);
  expect_near(l.radiance(Vec3(0, 0, -1)), Rgb(0.5f), 1e-4f);
  const SceneGraph turned = read_world("Rotate -90 1 0 0 " + light, notes, "", folder.path());
  expect_near(std::get<EnvironmentLight>(turned.lights().at(0)).radiance(Vec3(0, 1, 0)), Rgb(2), 1e-4f);
  EXPECT_TRUE(notes.empty());
}

// Of a constant map pbrt's measure is half of π L.
TEST(PbrtLights, InfiniteImageIlluminance) {
  const TemporaryFolder folder;
  Image image(32, 32, rgb_channels());
  for (float& p : image.pixels()) p = 3;
  write_image(folder.path() / "sky.pfm", image);
  Notes notes;
  const SceneGraph graph = read_world(
      "LightSource \"infinite\" \"string filename\" \"sky.pfm\" \"float illuminance\" 1", notes, "", folder.path());
  EXPECT_NEAR(std::get<EnvironmentLight>(graph.lights().at(0)).radiance(Vec3(1, 0, 0)).g, 2 / pi, 0.01f);
}

TEST(PbrtLights, InfiniteNotesAndErrors) {
  const TemporaryFolder folder;
  write_image(folder.path() / "wide.pfm", Image(4, 2, rgb_channels()));
  Notes notes;
  read_world("LightSource \"infinite\" \"string filename\" \"wide.pfm\" \"point3 portal\" [ 0 0 0 1 0 0 1 1 0 0 1 0 ]",
             notes, "", folder.path());
  EXPECT_TRUE(has_note(notes, "latitude and longitude"));
  EXPECT_TRUE(has_note(notes, "'portal'"));
  EXPECT_NE(error_of([] {
              read_world("LightSource \"infinite\" \"string filename\" \"x\" \"rgb L\" [ 1 1 1 ]");
            }).find("takes 'L' or 'filename', not both"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              read_world("LightSource \"goniometric\"");
            }).find("s.pbrt:2:1: unknown light 'goniometric' (known: point, spot, distant, infinite)"),
            std::string::npos);
}

TEST(PbrtLights, AreaLightsEndWithTheirAttributes) {
  const SceneGraph graph = read_whole_world(
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [ 1 2 3 ] \"float scale\" 2 \"bool twosided\" true "
      "Shape \"sphere\" AttributeEnd Shape \"sphere\"");
  const std::vector<Shown> all = shown(graph);
  ASSERT_EQ(all.size(), 2u);
  ASSERT_TRUE(all[0].surface.emission);
  EXPECT_EQ(all[0].surface.emission->radiance.value, Rgb(2, 4, 6));
  EXPECT_TRUE(all[0].surface.emission->two_sided);
  EXPECT_FALSE(all[1].surface.emission);
}

// Φ = π A L for a one-sided diffuse emitter.
TEST(PbrtLights, AreaLightPower) {
  const auto radiance = [](const std::string& world) {
    const SceneGraph graph = read_whole_world(world);
    return shown(graph).at(0).surface.emission->radiance.value.g;
  };
  const std::string light = "AreaLightSource \"diffuse\" \"float power\" 100 ";
  EXPECT_NEAR(radiance(light + "Shape \"sphere\" \"float radius\" 2"), 100 / (pi * 16 * pi), 1e-4f);
  EXPECT_NEAR(radiance(light + "Scale 2 2 2 Shape \"sphere\""), 100 / (pi * 16 * pi), 1e-4f);
  const std::string square =
      "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0 1 0 0 1 1 0 0 1 0 ] \"integer indices\" [ 0 1 2 0 2 3 ]";
  EXPECT_NEAR(radiance(light + "Scale 2 3 1 " + square), 100 / (pi * 6), 1e-4f);
}

TEST(PbrtLights, AreaLightErrorsStandAtTheLight) {
  EXPECT_NE(error_of([] { read_world("\nAreaLightSource \"area\""); }).find("s.pbrt:3:1: unknown area light 'area'"),
            std::string::npos);
  EXPECT_NE(error_of([] { read_world("AreaLightSource \"diffuse\" \"float L\" 1"); }).find("s.pbrt:2:27:"),
            std::string::npos);
}

}  // namespace
}  // namespace lambert
