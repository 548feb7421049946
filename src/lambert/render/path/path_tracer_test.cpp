#include "lambert/render/path/path_test_tools.h"

#include "lambert/base/hash.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

TriangleMesh square_facing(Vec3 centre, Vec3 half_u, Vec3 half_v) {
  TriangleMesh mesh;
  mesh.positions = {centre - half_u - half_v, centre + half_u - half_v, centre + half_u + half_v,
                    centre - half_u + half_v};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A glossy floor in z = 0 under lamps of every kind; the lamps may be seen by scattered rays as well as sampled.
SceneGraph lamps(int count, MaterialModel floor) {
  SceneGraph graph;
  const MaterialId ground = graph.materials.add({.model = std::move(floor)});
  const MaterialId black = graph.materials.add({.model = DiffuseMaterial{RgbParameter{Rgb(0)}}});
  graph.add_surface(0,
                    {.geometry = graph.add_geometry(square_facing(Vec3(0), {5, 0, 0}, {0, 5, 0})), .material = ground});
  for (int i = 0; i < count; ++i) {
    const float angle = 2.4f * static_cast<float>(i), radius = 0.6f * std::sqrt(static_cast<float>(i));
    const Vec3 at(radius * std::cos(angle), radius * std::sin(angle), 1 + 0.3f * static_cast<float>(i % 3));
    Surface lamp{.material = black};
    lamp.emission = Emission{.radiance = {Rgb(i % 4 == 0 ? 8.0f : 1.0f)}};
    lamp.geometry = i % 3 == 0   ? graph.add_geometry(square_facing(at, {0, 0.2f, 0}, {0.2f, 0, 0}))
                    : i % 3 == 1 ? graph.add_geometry(transformed(icosphere(0.15f, 0), Transform::translate(at)))
                                 : graph.add_geometry(Shape(Sphere{.radius = 0.1f, .z_min = -0.1f, .z_max = 0.1f}));
    const NodeId n = graph.add_node(0, "lamp", i % 3 == 2 ? Transform::translate(at) : Transform());
    graph.add_surface(n, lamp);
  }
  return graph;
}

Camera from_the_side() {
  Camera camera;
  camera.to_world = Transform::look_at({0, -3, 0.5f}, {0, 0, 0}, {0, 0, 1});
  camera.projection = Perspective{.half_width = 0.2f, .half_height = 0.1f};
  camera.resolution = {12, 6};
  return camera;
}

// rows: PT-28
TEST(PathTracer, HowALightIsChosenDoesNotChangeTheMean) {
  const MaterialModel grey = DiffuseMaterial{RgbParameter{Rgb(0.5f)}};
  const MaterialModel glossy = ConductorMaterial{.roughness = {.u = {0.2f}, .v = {0.2f}, .remap = false}};
  for (const MaterialModel& floor : {grey, glossy}) {
    for (const int count : {2, 9}) {
      std::vector<SeenMean> seen;
      for (const std::string& name : light_strategy_names()) {
        SceneGraph graph = lamps(count, floor);
        graph.add_light(EnvironmentLight(Rgb(0.1f)));
        graph.add_light(PointLight{.position = {0, 0, 2}, .intensity = Rgb(0.2f)});
        const Scene scene = compile(std::move(graph), {.light_strategy = light_strategy(name)});
        seen.push_back(path_mean(scene, from_the_side(), {{"max-depth", "2"}}, 256, hash_values(count)));
      }
      for (std::size_t i = 1; i < seen.size(); ++i) {
        const double difference = static_cast<double>(luminance(seen[i].mean) - luminance(seen[0].mean));
        const auto result =
            statistics::z_test(difference, std::hypot(seen[i].standard_error, seen[0].standard_error), 0, 8);
        EXPECT_TRUE(result) << light_strategy_names()[i] << " of " << count << ": " << result.message;
        EXPECT_LT(seen[i].standard_error, 0.05 * static_cast<double>(luminance(seen[i].mean)));
      }
    }
  }
}

/// The same lamp as a light and as a mere glow: then only scattered rays find it, which needs depth one more.
// E-PT-11: each path's emission counts once, whether the light was sampled or hit.
// rows: PT-25 PT-27 PT-29
TEST(PathTracer, SamplingLightsAndHittingThemAgree) {
  for (const float alpha : {0.05f, 0.3f, 1.0f}) {
    const ConductorMaterial metal{.roughness = {.u = {alpha}, .v = {alpha}, .remap = false}};
    SceneGraph graph = lamps(1, metal);
    const Camera camera = from_the_side();
    const Scene scene = compile(std::move(graph));
    const SeenMean both = path_mean(scene, camera, {{"max-depth", "1"}}, 1024);

    // By the definition: one scattered ray a sample, nothing else.
    double sum = 0, squares = 0;
    constexpr int count = 200000;
    for (int i = 0; i < count; ++i) {
      const auto u = [&](int k) { return hash_to_float(hash_values(i, k)); };
      const Ray ray =
          camera.ray({u(0) * static_cast<float>(camera.resolution.x), u(1) * static_cast<float>(camera.resolution.y)})
              .ray;
      double value = 0;
      if (Hit hit; scene.intersect(ray, hit)) {
        const SurfacePoint p = scene.surface_point(ray, hit);
        value += static_cast<double>(luminance(scene.emitted(p, -ray.direction)));
        const Frame frame(p.ns);
        const Bsdf bsdf = make_bsdf(scene.materials()[p.material], scene.textures(), {});
        if (const auto s = bsdf.sample(frame.to_local(-ray.direction), u(2), {u(3), u(4)})) {
          const Vec3 wi = normalize(frame.to_world(s->wi));
          const Ray next{offset_ray_origin(p.position, dot(wi, p.ng) < 0 ? -p.ng : p.ng), wi};
          if (Hit far; scene.intersect(next, far))
            value += static_cast<double>(luminance(s->weight * scene.emitted(scene.surface_point(next, far), -wi)));
        }
      }
      sum += value, squares += value * value;
    }
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
    const auto result = statistics::z_test(static_cast<double>(luminance(both.mean)) - mean,
                                           std::hypot(error, both.standard_error), 0, 3);
    EXPECT_TRUE(result) << "alpha " << alpha << ": " << luminance(both.mean) << " or " << mean << "; "
                        << result.message;
    EXPECT_LT(both.standard_error, 0.02 * mean);
    EXPECT_LT(error, 0.08 * mean);
  }
}

// The walls of a furnace: depth n sees the sum of albedo^k up to n.
// rows: PT-23
TEST(PathTracer, DepthCutsTheSeries) {
  SceneGraph graph;
  Surface wall{.geometry = graph.add_geometry(Shape(Sphere{})),
               .material = graph.materials.add({.model = DiffuseMaterial{RgbParameter{Rgb(0.5f)}}})};
  wall.emission = Emission{.radiance = {Rgb(1)}};
  wall.reverse_orientation = true;
  graph.add_surface(0, wall);
  const Scene scene = compile(std::move(graph));
  Camera camera = facing_camera();
  camera.to_world = {};
  double expected = 0;
  for (int depth = 0; depth < 5; ++depth) {
    expected += std::pow(0.5, depth);
    const SeenMean seen = path_mean(scene, camera, {{"max-depth", std::to_string(depth)}}, 256);
    EXPECT_NEAR(static_cast<double>(seen.mean.g), expected, 4 * seen.standard_error + 1e-3) << "depth " << depth;
  }
}

TEST(PathTracer, TheClampHoldsContributionsAfterTheFirstBounce) {
  SceneGraph graph = lamps(1, DiffuseMaterial{RgbParameter{Rgb(0.5f)}});
  graph.add_light(EnvironmentLight(Rgb(5)));
  const Scene scene = compile(std::move(graph));
  const float free = luminance(path_mean(scene, from_the_side()).mean);
  const float clamped = luminance(path_mean(scene, from_the_side(), {{"clamp", "0.01"}}).mean);
  const float direct = luminance(path_mean(scene, from_the_side(), {{"max-depth", "1"}}).mean);
  EXPECT_LT(clamped, free);
  EXPECT_GT(clamped, 0);
  // What is seen directly is not clamped.
  Camera up = facing_camera();
  EXPECT_GT(direct, 0);
  up.to_world = Transform::translate({3, 0, 9}) * Transform::rotate(degrees(180), {1, 0, 0});
  EXPECT_FLOAT_EQ(path_mean(scene, up, {{"clamp", "0.01"}}).mean.g, 5);
}

// What is unlit is seen but lights nothing.
TEST(PathTracer, UnlitSurfacesAreSeenButCastNoLight) {
  SceneGraph graph = lamps(1, DiffuseMaterial{RgbParameter{Rgb(0.5f)}});
  Surface glow = graph.surfaces(1)[0];
  glow.emission->casts_light = false;
  SceneGraph dark;
  dark.materials = graph.materials;
  const GeometryId floor = dark.add_geometry(graph.geometry(0)), lamp = dark.add_geometry(graph.geometry(1));
  dark.add_surface(0, {.geometry = floor, .material = 0});
  glow.geometry = lamp;
  dark.add_surface(0, glow);
  const Scene scene = compile(std::move(dark));
  EXPECT_EQ(path_mean(scene, from_the_side()).mean, Rgb());
  Camera below = facing_camera(0.05f);
  below.to_world = Transform::translate({0, 0, 0.5f}) * Transform::rotate(degrees(180), {1, 0, 0});
  EXPECT_FLOAT_EQ(path_mean(scene, below).mean.g, 8);
}

}  // namespace
}  // namespace lambert
