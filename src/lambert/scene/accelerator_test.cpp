#include "lambert/scene/scene_test_tools.h"

#include "lambert/geometry/ray_tests.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

// E-IS-16: a unit cube scaled by 2, a ray from (4, 0, 0) towards it: 1 in the cube's space (whose lengths are doubled),
// 2 in the world, at (2, 0, 0).
// rows: IS-55 IS-56 IS-57
TEST(Accelerator, TheScaledCube) {
  const Transform twice = Transform::scale(Vec3(2));
  const Ray world{.origin = {4, 0.1f, 0.2f}, .direction = {-1, 0, 0}};
  const Ray local = twice.inverse().ray(world);
  EXPECT_EQ(local.origin.x, 2);
  EXPECT_FLOAT_EQ((local.origin.x - 1) / length(local.direction) * length(local.direction), 1);

  for (const bool instanced : {false, true}) {
    for (const bool analytic : {false, true}) {
      SceneGraph graph;
      const MaterialId grey = add_grey(graph);
      using Plane = ConvexPolyhedron::Plane;
      const GeometryId cube =
          analytic ? graph.add_geometry(
                         Shape(ConvexPolyhedron({Plane{{1, 0, 0}, 1}, Plane{{-1, 0, 0}, 1}, Plane{{0, 1, 0}, 1},
                                                 Plane{{0, -1, 0}, 1}, Plane{{0, 0, 1}, 1}, Plane{{0, 0, -1}, 1}})))
                   : graph.add_geometry(box(Vec3(-1), Vec3(1)));
      graph.add_surface(graph.add_node(0, "cube", twice), {.geometry = cube, .material = grey});
      if (instanced)
        graph.add_surface(graph.add_node(0, "far", Transform::translate({0, 90, 0})),
                          {.geometry = cube, .material = grey});
      const Scene scene = compile(std::move(graph));
      const auto hit = nearest(scene, world);
      ASSERT_TRUE(hit);
      EXPECT_FLOAT_EQ(hit->t, 2);
      const SurfacePoint point = scene.surface_point(world, *hit);
      EXPECT_LT(length(point.position - Vec3(2, 0.1f, 0.2f)), 1e-5f);
      EXPECT_LT(length(point.ng - Vec3(1, 0, 0)), 1e-6f);
    }
  }
}

/// Every kind of geometry, each placed once or twice, some mirrored and all stretched.
struct Crowd {
  struct Placed {
    Geometry geometry;
    Transform to_world;
  };
  std::vector<Placed> placed;
  SceneGraph graph;

  explicit Crowd(Random& random) {
    const MaterialId grey = add_grey(graph);
    const std::vector<Geometry> geometries = {
        icosphere(1, 1),
        torus(1, 0.4f, 8, 6),
        box(Vec3(-0.5f), Vec3(0.7f)),
        Shape(Sphere{}),
        Shape(Sphere{.z_min = -0.3f, .z_max = 0.8f, .phi_max = 4}),
        Shape(Disk{.radius = 1.5f, .inner_radius = 0.4f}),
        Shape(Cylinder{.radius = 0.6f, .caps = true}),
        Shape(Cylinder{.radius = 0.6f, .phi_max = 3}),
        Shape(Polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5f, 0}})),
        Shape(ConvexPolyhedron({{{1, 1, 1}, 1}, {{-1, 0, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, -1}, 1}})),
    };
    for (std::size_t i = 0; i < geometries.size(); ++i) {
      const GeometryId id = graph.add_geometry(geometries[i]);
      for (std::size_t copy = 0; copy < 1 + i % 2; ++copy) {
        const Transform place = random_placement(random, (i + copy) % 3 == 0);
        graph.add_surface(graph.add_node(0, "n", place), {.geometry = id, .material = grey});
        placed.push_back({geometries[i], place});
      }
    }
  }
};

struct Expected {
  double t = std::numeric_limits<double>::infinity();
  std::size_t surface = 0;
};

/// Over all surfaces with no hierarchy: triangles by the textbook's test in double, shapes by their own.
Expected by_brute_force(const std::vector<Crowd::Placed>& placed, const Ray& ray) {
  Expected best;
  const auto offer = [&](double t, std::size_t surface) {
    if (t < best.t) best = {t, surface};
  };
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Transform& m = placed[i].to_world;
    if (const auto* mesh = std::get_if<TriangleMesh>(&placed[i].geometry)) {
      for (const Triangle& t : mesh->triangles) {
        const auto corner = [&](std::size_t k) { return Vec3d(m.point(mesh->positions[t[k]])); };
        if (const auto at = ray_triangle(Vec3d(ray.origin), Vec3d(ray.direction), corner(0), corner(1), corner(2)))
          offer(*at, i);
      }
    } else {
      const auto hit = std::visit([&](const auto& s) { return s.intersect(m.inverse().ray(ray)); },
                                  std::get<Shape>(placed[i].geometry));
      if (hit) offer(static_cast<double>(hit->t), i);
    }
  }
  return best;
}

// rows: IS-55 IS-56
TEST(Accelerator, FindsWhatASearchWithoutHierarchyFinds) {
  for (int seed = 0; seed < 3; ++seed) {
    Random random(seed);
    Crowd crowd(random);
    const auto placed = crowd.placed;
    const Scene scene = compile(std::move(crowd.graph));
    int hits = 0, disagreements = 0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
      const Ray ray{.origin = random.cube(8), .direction = random.direction()};
      const Expected expected = by_brute_force(placed, ray);
      const auto hit = nearest(scene, ray);
      hits += hit.has_value();
      const bool same = hit ? hit->surface == expected.surface &&
                                  std::abs(static_cast<double>(hit->t) - expected.t) < 1e-4 * (1 + expected.t)
                            : std::isinf(expected.t);
      disagreements += !same;
    }
    EXPECT_GT(hits, count / 10);
    EXPECT_LE(disagreements, 2) << "rays within rounding of an edge apart";
  }
}

TEST(Accelerator, OccludedAgreesWithIntersect) {
  Random random(5);
  Crowd crowd(random);
  const Scene scene = compile(std::move(crowd.graph));
  int occluded = 0;
  for (int i = 0; i < 20000; ++i) {
    Ray ray{.origin = random.cube(8), .direction = random.direction()};
    ray.t_min = random.between(0, 3), ray.t_max = ray.t_min + random.between(0, 8);
    const auto hit = nearest(scene, ray);
    EXPECT_EQ(scene.occluded(ray), hit.has_value());
    if (!hit) continue;
    ++occluded;
    EXPECT_GE(hit->t, ray.t_min);
    EXPECT_LE(hit->t, ray.t_max);
  }
  EXPECT_GT(occluded, 1000);
}

TEST(Accelerator, RobustModeLeavesNoCracks) {
  SceneGraph graph;
  const MaterialId grey = add_grey(graph);
  graph.add_surface(graph.add_node(0, "ball", Transform::scale({1, 2, 3})),
                    {.geometry = graph.add_geometry(icosphere(1, 2)), .material = grey});
  const TriangleMesh ball = transformed(icosphere(1, 2), Transform::scale({1, 2, 3}));
  const Scene scene = compile(std::move(graph), {.robust = true});
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    const Triangle& t = ball.triangles[static_cast<std::size_t>(random.number() * 320)];
    const float s = random.number();
    const Vec3 on_edge = (1 - s) * ball.positions[t[0]] + s * ball.positions[t[1]];
    EXPECT_TRUE(scene.occluded({.origin = random.cube(0.1f), .direction = normalize(on_edge)}));
  }
}

}  // namespace
}  // namespace lambert
