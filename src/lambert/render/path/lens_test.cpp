/// What a thin lens blurs, in closed form.

#include "lambert/render/path/path_test_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lambert {
namespace {

/// A glowing half plane, x > 0, at z = -distance.
Scene bright_half(float distance) {
  SceneGraph graph;
  TriangleMesh mesh;
  mesh.positions = {{0, -100, -distance}, {200, -100, -distance}, {200, 100, -distance}, {0, 100, -distance}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  Surface half{.geometry = graph.add_geometry(std::move(mesh)),
               .material = graph.materials.add({.model = DiffuseMaterial{RgbParameter{Rgb(0)}}})};
  half.emission = Emission{.radiance = {Rgb(1)}};
  graph.add_surface(0, half);
  return compile(std::move(graph));
}

/// The part of the unit disk with x < t.
double disk_below(double t) {
  if (std::abs(t) >= 1) return t > 0 ? 1 : 0;
  return 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) * std::numbers::inv_pi;
}

// The ray from the lens at l to the focus at X, F away, has x = X D/F + l (1 - D/F) where it meets the plane D away: of
// the lens the part sees light in which l (D/F - 1) < X D/F.
// rows: PT-32
TEST(ThinLens, BlursAnEdgeByTheShapeOfTheLens) {
  constexpr float radius = 0.1f, focus = 3;
  for (const float distance : {1.5f, 6.0f}) {
    const Scene scene = bright_half(distance);
    for (const float t : {-1.2f, -0.7f, -0.2f, 0.0f, 0.5f, 0.9f, 1.1f}) {
      const float blur = distance / focus - 1;
      Camera camera;
      camera.projection = Perspective{.half_width = 1e-5f,
                                      .half_height = 1e-5f,
                                      .centre = {t * radius * std::abs(blur) / distance, 0},
                                      .lens_radius = radius,
                                      .focal_distance = focus};
      camera.resolution = {8, 8};
      const SeenMean seen = path_mean(scene, camera, {}, 256);
      EXPECT_NEAR(static_cast<double>(seen.mean.g), disk_below(static_cast<double>(t)), 4 * seen.standard_error + 1e-4)
          << "t " << t << ", distance " << distance;
      EXPECT_LT(seen.standard_error, 0.005);
    }
  }
}

// rows: PT-32
TEST(ThinLens, KeepsWhatIsInFocusSharp) {
  const Scene scene = bright_half(3);
  for (const float x : {-1e-3f, 1e-3f}) {
    Camera camera;
    camera.projection = Perspective{
        .half_width = 1e-5f, .half_height = 1e-5f, .centre = {x, 0}, .lens_radius = 0.3f, .focal_distance = 3};
    camera.resolution = {4, 4};
    EXPECT_EQ(path_mean(scene, camera, {}, 64).mean.g, x > 0 ? 1 : 0);
  }
}

}  // namespace
}  // namespace lambert
