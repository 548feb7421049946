#include "lambert/scene/scene_test_tools.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

/// The geometry at `place`, by itself (so baked into the world, if a mesh) or beside a far copy (so instanced).
Scene placed(const Geometry& geometry, const Transform& place, bool instanced, bool reversed = false) {
  SceneGraph graph;
  const Surface s{
      .geometry = graph.add_geometry(geometry), .material = add_grey(graph), .reverse_orientation = reversed};
  graph.add_surface(graph.add_node(0, "thing", place), s);
  if (instanced) graph.add_surface(graph.add_node(0, "far", Transform::translate({0, 0, 500})), s);
  return compile(std::move(graph));
}

std::optional<SurfacePoint> seen(const Scene& scene, const Ray& ray) {
  const auto hit = nearest(scene, ray);
  return hit ? std::optional(scene.surface_point(ray, *hit)) : std::nullopt;
}

TriangleMesh bumpy_ball() {
  TriangleMesh ball = uv_sphere(1, 12, 8);
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    ball.tangents.emplace_back(normalize(cross(Vec3(0.1f, 1, 0.2f), ball.normals[i])), 1);
    ball.uvs1.push_back(0.5f * ball.uvs[i] + Vec2(0.1f));
    ball.colours.emplace_back(0.5f + 0.5f * ball.positions[i], 0.7f);
  }
  return ball;
}

// rows: IS-55 IS-58
TEST(SurfacePoint, AnInstanceIsTheSameAsItsBakedCopy) {
  Random random(1);
  TriangleMesh plain = bumpy_ball();
  plain.tangents.clear();
  for (const TriangleMesh& mesh : {bumpy_ball(), plain}) {
    for (const bool mirror : {false, true}) {
      const Transform place = random_placement(random, mirror);
      const Scene baked = placed(mesh, place, false), instanced = placed(mesh, place, true);
      int compared = 0;
      for (int i = 0; i < 2000; ++i) {
        const Ray ray = random_line(random, baked.bounds().centre(), baked.bounds().radius());
        const auto a = seen(baked, ray), b = seen(instanced, ray);
        if (!a || !b || a->primitive != b->primitive) continue;
        ++compared;
        EXPECT_LT(length(a->position - b->position), 1e-4f);
        EXPECT_LT(length(a->ng - b->ng), 1e-4f);
        EXPECT_LT(length(a->ns - b->ns), 1e-4f);
        EXPECT_GT(dot(normalize(a->tangent), normalize(b->tangent)), 0.999f);
        EXPECT_EQ(a->bitangent_sign, b->bitangent_sign);
        EXPECT_LT(length(a->uv - b->uv), 1e-3f);
        EXPECT_LT(length(a->uv1 - b->uv1), 1e-3f);
        EXPECT_LT(length(a->colour - b->colour), 1e-2f);
        EXPECT_NEAR(a->uv_per_length / b->uv_per_length, 1, 1e-3);
      }
      EXPECT_GT(compared, 150);
    }
  }
}

// N' = (M^-1)^T N, made unit: of a sphere stretched to an ellipsoid, the gradient of x²/a² + y²/b² + z²/c².
// rows: IS-58
TEST(SurfacePoint, NormalsOfAnEllipsoid) {
  Random random(2);
  const Vec3 axes(1, 2, 0.5f);
  for (const bool mirror : {false, true}) {
    const Scene scene = placed(Shape(Sphere{}), Transform::scale(mirror ? axes * Vec3(1, -1, 1) : axes), false);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto point = seen(scene, random_line(random, Vec3(0), 2));
      if (!point) continue;
      ++hits;
      EXPECT_LT(length(point->ng - normalize(point->position / (axes * axes))), 1e-4f);
      EXPECT_NEAR(length(point->position / axes), 1, 1e-5);
      EXPECT_NEAR(dot(normalize(point->tangent), point->ng), 0, 1e-3);
    }
    EXPECT_GT(hits, 200);
  }
}

TEST(SurfacePoint, TheOutwardSideStaysOutside) {
  Random random(3);
  const std::vector<Geometry> closed = {bumpy_ball(), Shape(Sphere{}), Shape(Cylinder{.caps = true})};
  for (const Geometry& geometry : closed) {
    for (const bool mirror : {false, true}) {
      for (const bool reversed : {false, true}) {
        for (const bool instanced : {false, true}) {
          const Transform place = random_placement(random, mirror);
          const Scene scene = placed(geometry, place, instanced, reversed);
          const Vec3 centre = place.point(Vec3(0));
          for (int i = 0; i < 100; ++i) {
            const auto point = seen(scene, {.origin = centre, .direction = random.direction()});
            ASSERT_TRUE(point);
            EXPECT_EQ(dot(point->ng, point->position - centre) > 0, !reversed);
            EXPECT_GE(dot(point->ng, point->ns), 0);
            EXPECT_NEAR(length(point->ng), 1, 1e-5);
            EXPECT_NEAR(length(point->ns), 1, 1e-5);
          }
        }
      }
    }
  }
}

// A rectangle 4 by 2 whose uv run from 0 to 1: ∂p/∂u is its side, and a unit of length is √(1/8) of uv.
TEST(SurfacePoint, CoordinatesOfARectangle) {
  for (const bool instanced : {false, true}) {
    const Scene scene = placed(rectangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0}), Transform::scale(Vec3(2)), instanced);
    const auto point = seen(scene, {.origin = {1, 0.5f, 3}, .direction = {0, 0, -1}});
    ASSERT_TRUE(point);
    EXPECT_LT(length(point->uv - Vec2(0.25f)), 1e-6f);
    EXPECT_LT(length(point->tangent - Vec3(4, 0, 0)), 1e-5f);
    EXPECT_EQ(point->bitangent_sign, 1);
    EXPECT_LT(length(point->position - Vec3(1, 0.5f, 0)), 1e-6f);
    EXPECT_FLOAT_EQ(point->uv_per_length, std::sqrt(1 / 8.0f));
    EXPECT_EQ(point->light, no_light);
  }
}

TEST(SurfacePoint, WithoutCoordinatesTheBarycentricOnesStand) {
  TriangleMesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  const auto point = seen(placed(triangle, {}, false), {.origin = {0.2f, 0.3f, 1}, .direction = {0, 0, -1}});
  ASSERT_TRUE(point);
  EXPECT_LT(length(point->uv - Vec2(0.2f, 0.3f)), 1e-6f);
  EXPECT_EQ(point->uv1, point->uv);
  EXPECT_EQ(point->ns, Vec3(0, 0, 1));
}

// From 10,000 away t is good to a thousandth only; the point is still on the surface.
// The chord is shorter than the step back from which shapes are met once more.
TEST(SurfacePoint, FromInsideSmallShapesAndThoseFarAway) {
  for (const auto& [place, radius] : {std::pair(Vec3(0), 4e-4f), {Vec3(3000, 0, 0), 1.0f}, {Vec3(0, 0, -1e4f), 2.0f}}) {
    const Scene scene =
        placed(Shape(Sphere{.radius = radius, .z_min = -radius, .z_max = radius}), Transform::translate(place), false);
    const Vec3 direction = normalize(Vec3(1, 2, -0.5f));
    const auto p = seen(scene, {place - 0.9f * radius * direction, direction});
    ASSERT_TRUE(p);
    EXPECT_NEAR(length(p->position - (place + radius * direction)) / radius, 0, 2e-3f) << place.x << ' ' << radius;
    EXPECT_GT(dot(p->ng, direction), 0.99f);
  }
}

TEST(SurfacePoint, IsOnTheSurfaceSeenFromAfar) {
  Random random(4);
  for (const Geometry& geometry : {Geometry(Shape(Sphere{})), Geometry(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}))}) {
    const Scene scene = placed(geometry, {}, false);
    const bool sphere = std::holds_alternative<Shape>(geometry);
    for (int i = 0; i < 200; ++i) {
      const Vec3 target = random.cube(0.4f), from = 1e4f * normalize(Vec3(0.3f, 0.2f, 1) + random.cube(0.2f));
      const auto point = seen(scene, {.origin = from + target, .direction = normalize(-from)});
      if (!point) continue;
      EXPECT_LT(std::abs(sphere ? length(point->position) - 1 : point->position.z), 2e-6f);
    }
  }
}

}  // namespace
}  // namespace lambert
