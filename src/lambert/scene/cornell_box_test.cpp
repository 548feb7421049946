#include "lambert/scene/cornell_box.h"

#include "lambert/scene/scene_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

/// Where a ray of the published coordinates (mm; x to the left, z into the room) ends, in them.
std::optional<Vec3> seen(const Scene& scene, Vec3 from, Vec3 direction) {
  const auto turn = [](Vec3 v) { return Vec3(-v.x, v.y, -v.z); };
  const Ray ray{.origin = 1e-3f * turn(from), .direction = turn(normalize(direction))};
  const auto hit = nearest(scene, ray);
  return hit ? std::optional(1e3f * turn(scene.surface_point(ray, *hit).position)) : std::nullopt;
}

// The numbers of the published measurement, in mm.
TEST(CornellBox, HasThePublishedDimensions) {
  const Scene scene = compile(cornell_box());
  const Vec3 middle(278, 400, 279.6f);
  EXPECT_NEAR(seen(scene, middle, {0, 0, 1})->z, 559.2f, 0.01f);
  EXPECT_NEAR(seen(scene, middle, {-1, 0, 0})->x, 0, 0.01f);
  EXPECT_NEAR(seen(scene, {278, 0.01f, 50}, {1, 0, 0})->x, 552.8f, 0.5f) << "the left wall leans";
  EXPECT_NEAR(seen(scene, {278, 548.7f, 50}, {1, 0, 0})->x, 556, 0.5f);
  EXPECT_NEAR(seen(scene, {30, 400, 30}, {0, 1, 0})->y, 548.8f, 0.01f);
  EXPECT_NEAR(seen(scene, {30, 400, 30}, {0, -1, 0})->y, 0, 0.01f);
  EXPECT_NEAR(seen(scene, {185, 400, 170}, {0, -1, 0})->y, 165, 0.01f) << "the short block";
  EXPECT_NEAR(seen(scene, {368, 400, 350}, {0, -1, 0})->y, 330, 0.01f) << "the tall block";
  EXPECT_FALSE(seen(scene, middle, {0, 0, -1})) << "the front is open";
}

TEST(CornellBox, TheLampIsOneQuadOfThePublishedSize) {
  const Scene scene = compile(cornell_box());
  ASSERT_EQ(scene.lights().size(), 1u);
  const auto& lamp = std::get<QuadLight>(scene.lights()[0]);
  const float a = length(lamp.edge_u()), b = length(lamp.edge_v());
  EXPECT_NEAR(std::max(a, b), 0.130f, 1e-5f);
  EXPECT_NEAR(std::min(a, b), 0.105f, 1e-5f);
  EXPECT_LT(cross(lamp.edge_u(), lamp.edge_v()).y, 0) << "faces down";
  const Rgb radiance = lamp.emission().radiance.value;
  EXPECT_GT(radiance.r, radiance.g);
  EXPECT_GT(radiance.g, radiance.b);
}

TEST(CornellBox, WallsFaceTheRoomAndBlocksOutward) {
  const Scene scene = compile(cornell_box());
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{.origin = Vec3(-0.278f, 0.45f, -0.28f) + random.cube(0.05f), .direction = random.direction()};
    const auto hit = nearest(scene, ray);
    if (!hit) continue;
    EXPECT_LT(dot(scene.surface_point(ray, *hit).ng, ray.direction), 0);
  }
}

TEST(CornellBox, TheRedWallIsOnTheLeftOfTheImage) {
  SceneGraph graph = cornell_box();
  const Camera camera = graph.cameras().at(0);
  const Scene scene = compile(std::move(graph));
  const auto name_at = [&](float x, float y) {
    const Ray ray = camera.ray({x, y}).ray;
    const auto hit = nearest(scene, ray);
    return hit ? scene.object_name(scene.surface_point(ray, *hit).object) : "nothing";
  };
  EXPECT_EQ(name_at(30, 256), "left wall");
  EXPECT_EQ(name_at(482, 256), "right wall");
  EXPECT_EQ(name_at(256, 200), "back wall");
  EXPECT_EQ(name_at(256, 15), "ceiling");
  EXPECT_EQ(name_at(256, 500), "floor");
}

}  // namespace
}  // namespace lambert
