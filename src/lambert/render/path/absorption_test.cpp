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

// glTF's transmission with KHR_materials_volume.
TEST(Absorption, InsideGltfVolumes) {
  GltfMaterial glass{.metallic = {0}, .roughness = {0}, .ior = 1.0001f, .transmission = {1}, .thin_walled = false};
  const Material material{.model = glass, .absorption = Rgb(0.2f, 0.4f, 0.8f)};
  const Rgb mean = path_mean(in_white(Shape(Sphere{}), material), straight(), no_roulette).mean;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], std::exp(-2 * material.absorption[c]), 3e-3f);
}

}  // namespace
}  // namespace lambert
