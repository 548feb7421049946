#include "lambert/base/notes.h"
#include "lambert/scene/scene_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

SceneGraph far_box() {
  SceneGraph graph;
  const MaterialId grey = add_grey(graph);
  graph.add_surface(graph.add_node(0, "box", Transform::translate({100, 20, -30})),
                    {.geometry = graph.add_geometry(box(Vec3(-1), Vec3(2, 0.1f, 7))), .material = grey});
  return graph;
}

void expect_seen_whole(const SceneGraph& graph) {
  const Camera camera = graph.cameras().at(0);
  const auto& lens = std::get<Perspective>(camera.projection);
  const Bounds3 bounds = graph.world_bounds(graph.root());
  for (int i = 0; i < 8; ++i) {
    const Vec3 p = camera.to_world.inverse().point(bounds.corner(i));
    EXPECT_LT(p.z, 0) << "behind the camera";
    EXPECT_LT(std::abs(p.x / -p.z - lens.centre.x), lens.half_width);
    EXPECT_LT(std::abs(p.y / -p.z - lens.centre.y), lens.half_height);
  }
}

TEST(AddMissing, SaysSoAndSeesTheWholeBox) {
  SceneGraph graph = far_box();
  Notes notes;
  add_missing_camera_and_light(graph, notes);
  EXPECT_EQ(notes.counts().size(), 2u);
  EXPECT_TRUE(notes.counts().contains("the scene has no camera: framed it as a whole"));
  EXPECT_TRUE(notes.counts().contains("the scene has no light: added a studio environment"));
  ASSERT_EQ(graph.cameras().size(), 1u);
  ASSERT_EQ(graph.lights().size(), 1u);
  EXPECT_EQ(graph.cameras()[0].resolution, default_resolution);
  expect_seen_whole(graph);
}

TEST(AddMissing, FramesForTheResolutionAskedFor) {
  for (const Vec2i resolution : {Vec2i(180, 180), Vec2i(90, 400), Vec2i(1000, 100)}) {
    SceneGraph graph = far_box();
    Notes notes;
    add_missing_camera_and_light(graph, notes, resolution);
    EXPECT_EQ(graph.cameras().at(0).resolution, resolution);
    expect_seen_whole(graph);
  }
}

TEST(AddMissing, LeavesWhatIsThere) {
  SceneGraph graph = far_box();
  graph.add_camera({.name = "mine"});
  graph.add_light(PointLight{});
  Notes notes;
  add_missing_camera_and_light(graph, notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(graph.cameras().size(), 1u);
  EXPECT_EQ(graph.lights().size(), 1u);
}

TEST(AddMissing, AnEmittingSurfaceIsALight) {
  SceneGraph graph = far_box();
  Surface lamp{.geometry = 0, .material = 0};
  lamp.emission = Emission{};
  graph.add_surface(graph.root(), lamp);
  Notes notes;
  add_missing_camera_and_light(graph, notes);
  EXPECT_TRUE(graph.lights().empty());
  EXPECT_EQ(notes.counts().size(), 1u);
}

TEST(AddMissing, AnEmptySceneGetsACameraThatWorks) {
  SceneGraph graph;
  Notes notes;
  add_missing_camera_and_light(graph, notes);
  const Camera camera = graph.cameras().at(0);
  const Vec3 d = camera.ray(Vec2(camera.resolution) / 2.0f).ray.direction;
  EXPECT_NEAR(length(d), 1, 1e-5);
}

}  // namespace
}  // namespace lambert
