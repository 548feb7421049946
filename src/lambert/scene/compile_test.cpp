#include "lambert/base/error.h"
#include "lambert/scene/compiled.h"
#include "lambert/scene/scene_test_tools.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace lambert {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

void expect_refused(SceneGraph graph, const std::string& words) {
  try {
    compile(std::move(graph));
    ADD_FAILURE() << "compiled; expected an error with: " << words;
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
}

SceneGraph one_box(const Transform& place = {}) {
  SceneGraph graph;
  const NodeId n = graph.add_node(graph.root(), "box", place);
  const MaterialId grey = add_grey(graph);
  graph.add_surface(n, {.geometry = graph.add_geometry(box(Vec3(-1), Vec3(1))), .material = grey});
  return graph;
}

TEST(Compile, InstancesShareGeometryAndCountEach) {
  SceneGraph graph = one_box();
  for (int i = 1; i < 5; ++i) {
    const NodeId n = graph.add_node(graph.root(), "copy " + std::to_string(i),
                                    Transform::translate({4.0f * static_cast<float>(i), 0, 0}));
    graph.add_surface(n, {.geometry = 0, .material = 0});
  }
  const Scene scene = compile(std::move(graph));
  EXPECT_EQ(scene.triangle_count(), 60u);
  for (std::uint32_t i = 0; i < 5; ++i) {
    const float x = 4.0f * static_cast<float>(i);
    const Ray ray{.origin = {x, 5, 0.1f}, .direction = {0, -1, 0}};
    const auto hit = nearest(scene, ray);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->surface, i);
    const SurfacePoint point = scene.surface_point(ray, *hit);
    EXPECT_LT(length(point.position - Vec3(x, 1, 0.1f)), 1e-5f);
    EXPECT_EQ(scene.object_name(point.object), i == 0 ? "box" : "copy " + std::to_string(i));
  }
  EXPECT_FALSE(nearest(scene, {.origin = {2, 5, 0}, .direction = {0, -1, 0}})) << "between two";
  EXPECT_LT(length(scene.bounds().max - Vec3(17, 1, 1)), 1e-5f);
}

TEST(Compile, AGeometryTwiceInOneNodeIsFoundOnceEach) {
  SceneGraph graph = one_box();
  const MaterialId other = add_grey(graph, 0.1f);
  graph.add_surface(1, {.geometry = 0, .material = other});
  EXPECT_EQ(compile(std::move(graph)).triangle_count(), 24u);
}

TEST(Compile, AnEmptySceneHasNothingToHit) {
  const Scene scene = compile(SceneGraph());
  EXPECT_FALSE(nearest(scene, {}));
  EXPECT_FALSE(scene.occluded({}));
  EXPECT_TRUE(scene.lights().empty());
  EXPECT_EQ(scene.environment_radiance({0, 1, 0}), Rgb());
}

TEST(Compile, NamesTheNodeOfASingularTransform) { expect_refused(one_box(Transform::scale({1, 0, 1})), "node 'box'"); }

TEST(Compile, NamesTheNodeOfAnUnknownMaterial) {
  SceneGraph graph = one_box();
  const NodeId n = graph.add_node(graph.root(), "stranger");
  graph.add_surface(n, {.geometry = 0, .material = 7});
  expect_refused(std::move(graph), "node 'stranger': a surface names material 7, but there are only 1");
}

TEST(Compile, RefusesAMixOfUnknownMaterials) {
  SceneGraph graph = one_box();
  graph.materials.add({.name = "mixed", .model = MixMaterial{0, 9}});
  EXPECT_THROW(compile(std::move(graph)), Error);
}

TEST(CheckFinite, NamesTheLight) {
  const std::vector<Light> lights = {PointLight{.position = {0, nan, 0}},
                                     PointLight{.intensity = Rgb(nan, 0, 0)},
                                     SpotLight{.cos_outer = nan},
                                     DirectionalLight{.direction = {nan, 0, 0}},
                                     TriangleLight{{Vec3(0), Vec3(nan), Vec3(1)}, {}, {}},
                                     QuadLight({0, 0, 0}, {1, nan, 0}, {0, 1, 0}, {}, {}),
                                     ShapeLight{.emission = {{Rgb(nan)}}},
                                     EnvironmentLight(Rgb(nan))};
  for (const Light& light : lights) {
    SceneGraph graph = one_box();
    graph.add_light(PointLight{});
    graph.add_light(light);
    expect_refused(std::move(graph), "light 1 has a number that is not finite");
  }
}

TEST(CheckFinite, NamesTheMaterial) {
  const std::vector<std::function<void(Material&)>> spoil = {
      [](Material& m) { m.model = DiffuseMaterial{RgbParameter{Rgb(nan)}}; },
      [](Material& m) { m.model = DielectricMaterial{.eta = std::numeric_limits<float>::infinity()}; },
      [](Material& m) { m.model = GltfMaterial{.ior = nan}; },
      [](Material& m) { m.model = CoatedDiffuseMaterial{.eta = nan}; },
      [](Material& m) { m.absorption = Rgb(0, nan, 0); },
      [](Material& m) { m.alpha.value = nan; },
  };
  for (const auto& change : spoil) {
    SceneGraph graph = one_box();
    change(graph.materials[0]);
    expect_refused(std::move(graph), "material 'grey' has a number that is not finite");
  }
}

TEST(CheckFinite, NamesTheCameraAndTheEmittingNode) {
  SceneGraph with_camera = one_box();
  with_camera.add_camera({.name = "eye", .to_world = Transform::translate({nan, 0, 0})});
  expect_refused(std::move(with_camera), "camera 'eye' has a number that is not finite");

  SceneGraph with_lens = one_box();
  with_lens.add_camera({.name = "lens", .projection = Perspective{.lens_radius = nan}});
  expect_refused(std::move(with_lens), "camera 'lens' has a number that is not finite");

  SceneGraph with_lamp = one_box();
  Surface lamp{.geometry = 0, .material = 0};
  lamp.emission = Emission{.radiance = {Rgb(nan)}};
  with_lamp.add_surface(with_lamp.add_node(with_lamp.root(), "lamp"), lamp);
  expect_refused(std::move(with_lamp), "the emission of node 'lamp' has a number that is not finite");
}

}  // namespace
}  // namespace lambert
