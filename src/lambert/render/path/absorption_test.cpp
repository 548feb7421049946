#include "lambert/render/path/path_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

/// A narrow look straight through the middle.
Camera straight() { return facing_camera(1e-4f); }

const MethodWords no_roulette = {{"roulette-depth", "1000"}};

// A slab whose faces neither reflect nor bend: exp(-σ d) per channel (Beer and Lambert).
TEST(Absorption, ThroughASlabOfIndexOne) {
  const Rgb sigma(0.1f, 0.7f, 2);
  for (const float thickness : {0.5f, 1.0f, 2.0f}) {
    const Vec3 half(1, 1, thickness / 2);
    const Material gas{.model = DielectricMaterial{.eta = 1.0001f}, .absorption = sigma};
    const Rgb mean = path_mean(in_white(box(-half, half), gas), straight(), no_roulette).mean;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(mean[c], std::exp(-sigma[c] * thickness), 2e-3f) << thickness << ", channel " << c;
  }
}

// With reflecting faces (R at normal incidence) and τ = exp(-σ d), all orders sum to
// transmitted (1 - R)² τ / (1 - R² τ²) and reflected R + R (1 - R)² τ² / (1 - R² τ²).
TEST(Absorption, ThroughASlabOfGlassWithAllItsReflections) {
  const float reflectance = 0.04f, tau = std::exp(-0.5f);
  const float orders = 1 - reflectance * reflectance * tau * tau, passed = sqr(1 - reflectance);
  const float expected = (passed * tau + reflectance * passed * tau * tau) / orders + reflectance;
  const Material glass{.model = DielectricMaterial{.eta = 1.5f}, .absorption = Rgb(0.5f)};
  const SeenMean seen = path_mean(in_white(box({-1, -1, -0.5f}, {1, 1, 0.5f}), glass), straight(), no_roulette, 1024);
  EXPECT_NEAR(static_cast<double>(seen.mean.g), static_cast<double>(expected), 4 * seen.standard_error + 1e-4);
  EXPECT_LT(seen.standard_error, 2e-3);
}

TEST(Absorption, IsThatOfLengthsInTheWorld) {
  const Material gas{.model = DielectricMaterial{.eta = 1.0001f}, .absorption = Rgb(1)};
  const Scene scene = in_white(Shape(Sphere{}), gas, Transform::scale({1, 1, 0.25f}));
  EXPECT_NEAR(path_mean(scene, straight(), no_roulette).mean.g, std::exp(-0.5f), 2e-3f);
}

// A mirror inside: the way in and the way out, to the mirror and back, are absorbed, and so is what a lamp inside
// sends.
TEST(Absorption, UpToWhatStandsInside) {
  const float sigma = 0.8f;
  const Material gas{.model = DielectricMaterial{.eta = 1.0001f}, .absorption = Rgb(sigma)};
  const ConductorMaterial mirror{.reflectance = {Rgb(1)}, .use_reflectance = true};
  for (const bool lamp : {false, true}) {
    SceneGraph graph;
    graph.add_surface(0, {.geometry = graph.add_geometry(Shape(Sphere{})), .material = graph.materials.add(gas)});
    Surface core{.geometry = graph.add_geometry(box(Vec3(-0.25f), Vec3(0.25f))),
                 .material = graph.materials.add({.model = mirror})};
    if (lamp) core.emission = Emission{.radiance = {Rgb(3)}};
    graph.add_surface(0, core);
    if (!lamp) graph.add_light(EnvironmentLight(Rgb(1)));
    const Rgb mean = path_mean(compile(std::move(graph)), straight(), no_roulette).mean;
    EXPECT_NEAR(mean.g, lamp ? 3 * std::exp(-0.75f * sigma) : std::exp(-1.5f * sigma), 4e-3f) << "lamp " << lamp;
  }
}

// A diffuse core, lit through light sampling by a lamp that stands inside the same body, at distance about 0.6.
TEST(Absorption, OnTheWayToASampledLight) {
  const auto seen = [](Rgb sigma) {
    SceneGraph graph;
    const MaterialId gas = graph.materials.add({.model = DielectricMaterial{.eta = 1.0001f}, .absorption = sigma});
    const MaterialId grey = graph.materials.add({.model = DiffuseMaterial{RgbParameter{Rgb(0.5f)}}});
    graph.add_surface(0, {.geometry = graph.add_geometry(Shape(Sphere{})), .material = gas});
    graph.add_surface(0,
                      {.geometry = graph.add_geometry(box({-0.2f, -0.2f, -0.2f}, {0.2f, 0.2f, 0})), .material = grey});
    graph.add_light(PointLight{.position = {0, 0, 0.6f}, .intensity = Rgb(1)});
    return path_mean(compile(std::move(graph)), straight(), no_roulette, 16).mean.g;
  };
  // From the lamp 0.6, and 1 from the core to the sphere.
  EXPECT_NEAR(seen(Rgb(0.7f)) / seen(Rgb(0)), std::exp(-0.7f * 1.6f), 3e-3f);
}

// glTF's transmission with KHR_materials_volume.
TEST(Absorption, InsideGltfVolumes) {
  GltfMaterial glass{.metallic = {0}, .roughness = {0}, .ior = 1.0001f, .transmission = {1}, .thin_walled = false};
  const Material material{.model = glass, .absorption = Rgb(0.2f, 0.4f, 0.8f)};
  const Rgb mean = path_mean(in_white(Shape(Sphere{}), material), straight(), no_roulette).mean;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], std::exp(-2 * material.absorption[c]), 3e-3f);
}

}  // namespace
}  // namespace lambert
