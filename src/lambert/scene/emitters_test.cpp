#include "lambert/base/notes.h"
#include "lambert/scene/scene_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

Surface lamp(SceneGraph& graph, Geometry geometry, Rgb radiance = Rgb(1), bool two_sided = false) {
  Surface s{.geometry = graph.add_geometry(std::move(geometry)), .material = add_grey(graph)};
  s.emission = Emission{.radiance = {radiance}, .two_sided = two_sided};
  return s;
}

template <class T>
std::size_t count_of(const Scene& scene) {
  std::size_t n = 0;
  for (const Light& l : scene.lights()) n += std::holds_alternative<T>(l);
  return n;
}

double total_power(const Scene& scene) {
  double sum = 0;
  for (const Light& l : scene.lights()) sum += static_cast<double>(light_bounds(l, scene.light_context()).power);
  return sum;
}

TEST(Emitters, TwoTrianglesOfARectangleAreOneLight) {
  SceneGraph graph;
  graph.add_surface(0, lamp(graph, rectangle({0, 0, 0}, {2, 0, 0}, {0.5f, 3, 0})));
  const Scene scene = compile(std::move(graph));
  ASSERT_EQ(scene.lights().size(), 1u);
  const auto& quad = std::get<QuadLight>(scene.lights()[0]);
  EXPECT_FLOAT_EQ(length(cross(quad.edge_u(), quad.edge_v())), 6);
  EXPECT_GT(cross(quad.edge_u(), quad.edge_v()).z, 0) << "emits where the mesh faces";
}

// A box of 12 triangles is 6 quads; a ball's triangles stay what they are. Power is π times radiance and area.
TEST(Emitters, PowerIsThatOfTheArea) {
  Random random(1);
  for (const bool instanced : {false, true}) {
    SceneGraph graph;
    const Transform place = random_placement(random, true);
    const Surface cube = lamp(graph, box(Vec3(0), Vec3(1, 2, 3)), Rgb(2));
    const Surface ball = lamp(graph, icosphere(1, 1), Rgb(3));
    graph.add_surface(graph.add_node(0, "cube", place), cube);
    graph.add_surface(graph.add_node(0, "ball", place), ball);
    if (instanced) graph.add_surface(0, cube), graph.add_surface(0, ball);
    const Scene scene = compile(std::move(graph));
    EXPECT_EQ(count_of<QuadLight>(scene), instanced ? 12u : 6u);
    EXPECT_EQ(count_of<TriangleLight>(scene), instanced ? 160u : 80u);
    const auto power = [](const TriangleMesh& mesh, float radiance) {
      return static_cast<double>(pi * radiance * mesh.area());
    };
    double expected =
        power(transformed(box(Vec3(0), Vec3(1, 2, 3)), place), 2) + power(transformed(icosphere(1, 1), place), 3);
    if (instanced) expected += power(box(Vec3(0), Vec3(1, 2, 3)), 2) + power(icosphere(1, 1), 3);
    EXPECT_NEAR(total_power(scene), expected, 1e-4 * expected);
  }
}

TEST(Emitters, APairThatIsNoParallelogramStaysTwoTriangles) {
  SceneGraph graph;
  TriangleMesh kite = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  kite.positions[2] = {1.5f, 1.5f, 0};
  graph.add_surface(0, lamp(graph, kite));
  EXPECT_EQ(count_of<TriangleLight>(compile(std::move(graph))), 2u);
}

TEST(Emitters, DarkUnlitAndFlatOnesAreNoLights) {
  SceneGraph graph;
  graph.add_surface(0, lamp(graph, box(Vec3(0), Vec3(1)), Rgb(0)));
  Surface unlit = lamp(graph, box(Vec3(0), Vec3(1)));
  unlit.emission->casts_light = false;
  graph.add_surface(0, unlit);
  TriangleMesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  graph.add_surface(0, lamp(graph, flat));
  EXPECT_TRUE(compile(std::move(graph)).lights().empty());
}

/// What a ray hits and what sampling the light finds must be one thing: ids, radiance, densities.
TEST(Emitters, HitsKnowTheirLight) {
  Random random(2);
  SceneGraph graph;
  int i = 0;
  for (const Geometry& g : {Geometry(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})), Geometry(icosphere(1, 1)),
                            Geometry(Shape(Sphere{})), Geometry(Shape(Disk{})), Geometry(Shape(Cylinder{}))}) {
    for (const bool mirror : {false, true}) {
      Surface s = lamp(graph, g, Rgb(static_cast<float>(++i)), true);
      s.reverse_orientation = i % 3 == 0;
      graph.add_surface(graph.add_node(0, "lamp", random_placement(random, mirror)), s);
    }
  }
  graph.add_light(PointLight{});
  const Scene scene = compile(std::move(graph));
  int compared = 0;
  for (int round = 0; round < 400; ++round) {
    const Vec3 from = random.cube(9);
    for (std::uint32_t id = 0; id < scene.lights().size(); ++id) {
      const auto s = sample_light(scene.lights()[id], scene.light_context(), from, random.square());
      if (!s || s->delta) continue;
      const Ray ray{.origin = from, .direction = s->wi};
      const auto hit = nearest(scene, ray);
      if (!hit || std::abs(hit->t - s->distance) > 1e-4f * s->distance) continue;  // hidden
      const SurfacePoint point = scene.surface_point(ray, *hit);
      if (point.light != id) continue;  // a neighbour across an edge; counted below
      ++compared;
      EXPECT_EQ(scene.emitted(point, -s->wi), s->radiance);
      EXPECT_TRUE(scene.casts_light(point));
      if (std::abs(dot(point.ng, s->wi)) < 0.05f) continue;
      EXPECT_NEAR(scene.light_pdf_omega(point, from) / s->pdf_omega, 1, 0.02);
    }
  }
  EXPECT_GT(compared, 5000);
}

TEST(Emitters, OneSidedEmissionLeavesTheOutwardSide) {
  for (const bool reversed : {false, true}) {
    for (const bool mirror : {false, true}) {
      for (const Geometry& g : {Geometry(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})), Geometry(Shape(Disk{}))}) {
        SceneGraph graph;
        Surface s = lamp(graph, g);
        s.reverse_orientation = reversed;
        graph.add_surface(graph.add_node(0, "lamp", Transform::scale({1, 1, mirror ? -1 : 1})), s);
        const Scene scene = compile(std::move(graph));
        const bool emits_up = reversed == mirror;
        for (const float side : {-1.0f, 1.0f}) {
          const bool expected = (side > 0) == emits_up;
          const Vec3 from(0.1f, 0.2f, side);
          EXPECT_EQ(sample_light(scene.lights()[0], scene.light_context(), from, Vec2(0.3f)).has_value(), expected);
          const Ray ray{.origin = from, .direction = {0, 0, -side}};
          const SurfacePoint point = scene.surface_point(ray, *nearest(scene, ray));
          EXPECT_EQ(!is_black(scene.emitted(point, {0, 0, side})), expected);
        }
      }
    }
  }
}

}  // namespace
}  // namespace lambert
