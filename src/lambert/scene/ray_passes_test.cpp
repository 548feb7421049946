/// What rays pass through: transparent texels and the backs of one-sided surfaces.

#include "lambert/scene/scene_test_tools.h"

#include "statistics/chi_square.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

enum class Kind { mesh, instance, shape };
const Kind kinds[] = {Kind::mesh, Kind::instance, Kind::shape};

/// The square |x|, |y| <= 1 in z = 0, facing +z, placed by `place`.
Scene square(Kind kind, Material material, const Transform& place = {}, bool reversed = false) {
  SceneGraph graph;
  Surface s{.material = graph.materials.add(std::move(material)), .reverse_orientation = reversed};
  s.geometry = kind == Kind::shape
                   ? graph.add_geometry(Shape(Polygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}})))
                   : graph.add_geometry(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  graph.add_surface(graph.add_node(0, "square", place), s);
  if (kind == Kind::instance) graph.add_surface(graph.add_node(0, "far", Transform::translate({90, 0, 0})), s);
  return compile(std::move(graph));
}

Ray down(float x, float y) { return {.origin = {x, y, 3}, .direction = {0, 0, -1}}; }
Ray up(float x, float y) { return {.origin = {x, y, -3}, .direction = {0, 0, 1}}; }

bool seen(const Scene& scene, const Ray& ray) {
  const bool hit = nearest(scene, ray).has_value();
  EXPECT_EQ(hit, scene.occluded(ray));
  return hit;
}

TEST(OneSided, TheBackLetsRaysPass) {
  const Material material{.double_sided = false};
  for (const Kind kind : kinds) {
    const Scene scene = square(kind, material);
    EXPECT_TRUE(seen(scene, down(0.1f, 0.2f)));
    EXPECT_FALSE(seen(scene, up(0.1f, 0.2f)));
    const Scene reversed = square(kind, material, {}, true);
    EXPECT_FALSE(seen(reversed, down(0.1f, 0.2f)));
    EXPECT_TRUE(seen(reversed, up(0.1f, 0.2f)));
  }
}

// A surface mirrored in its own plane still faces the same way: triangles are turned round.
TEST(OneSided, AMirroredSurfaceKeepsItsOutwardSide) {
  const Material material{.double_sided = false};
  for (const Kind kind : kinds) {
    const Scene in_plane = square(kind, material, Transform::scale({-1, 1, 1}));
    EXPECT_TRUE(seen(in_plane, down(0.1f, 0.2f))) << static_cast<int>(kind);
    EXPECT_FALSE(seen(in_plane, up(0.1f, 0.2f))) << static_cast<int>(kind);
    const Scene upside_down = square(kind, material, Transform::scale({1, 1, -1}));
    EXPECT_FALSE(seen(upside_down, down(0.1f, 0.2f))) << static_cast<int>(kind);
    EXPECT_TRUE(seen(upside_down, up(0.1f, 0.2f))) << static_cast<int>(kind);
  }
}

/// Alpha 1 on the left half of the square (u < 1/2), `right` on the other.
Material half_transparent(TextureSet& textures, AlphaMode mode, float right) {
  const TextureId a = textures.add(ConstantTexture{{1, 1, 1, 1}});
  const TextureId b = textures.add(ConstantTexture{{right, right, right, right}});
  CheckerboardTexture halves{.even = a, .odd = b};
  halves.uv.matrix = {2, 0, 0, 0, 0, 0.5f};
  return {.alpha_mode = mode, .alpha = {.value = 1, .texture = textures.add(halves), .channel = 0}};
}

Scene half_transparent_square(Kind kind, AlphaMode mode, float right) {
  SceneGraph graph;
  Surface s{.material = graph.materials.add(half_transparent(graph.textures, mode, right))};
  s.geometry = graph.add_geometry(rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
  graph.add_surface(graph.root(), s);
  if (kind == Kind::instance) graph.add_surface(graph.add_node(0, "far", Transform::translate({90, 0, 0})), s);
  return compile(std::move(graph));
}

TEST(Alpha, AMaskCutsAtItsThreshold) {
  for (const Kind kind : {Kind::mesh, Kind::instance}) {
    const Scene cut = half_transparent_square(kind, AlphaMode::mask, 0.49f);
    EXPECT_TRUE(seen(cut, down(-0.5f, 0.3f)));
    EXPECT_FALSE(seen(cut, down(0.5f, 0.3f)));
    EXPECT_TRUE(seen(half_transparent_square(kind, AlphaMode::mask, 0.5f), down(0.5f, 0.3f)));
  }
}

TEST(Alpha, BlendingStopsThatShareOfTheRays) {
  Random random(1);
  for (const Kind kind : {Kind::mesh, Kind::instance}) {
    const Scene scene = half_transparent_square(kind, AlphaMode::blend, 0.3f);
    int stopped = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
      EXPECT_TRUE(seen(scene, down(-random.between(0.01f, 0.99f), random.between(-1, 1))));
      stopped += seen(scene, down(random.between(0.01f, 0.99f), random.between(-1, 1)));
    }
    const auto result = statistics::z_test(stopped / double{count}, std::sqrt(0.3 * 0.7 / count), 0.3, 3);
    EXPECT_TRUE(result) << result.message;
  }
}

// A shape is met by its nearest point; what passes there goes on to the far side.
TEST(Alpha, RaysGoOnToTheFarSideOfAShape) {
  SceneGraph graph;
  graph.materials.add({.alpha_mode = AlphaMode::blend, .alpha = {.value = 0.4f}});
  graph.add_surface(graph.root(), {.geometry = graph.add_geometry(Shape(Sphere{}))});
  const Scene scene = compile(std::move(graph));
  Random random(2);
  int front = 0, back = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const Ray ray = down(random.between(-0.5f, 0.5f), random.between(-0.5f, 0.5f));
    EXPECT_EQ(scene.occluded(ray), nearest(scene, ray).has_value());
    if (const auto hit = nearest(scene, ray)) ++(hit->t < 3 ? front : back);
  }
  for (const auto& [hits, share] : {std::pair(front, 0.4), std::pair(back, 0.24)}) {
    const auto result = statistics::z_test(hits / double{count}, std::sqrt(share * (1 - share) / count), share, 3);
    EXPECT_TRUE(result) << result.message;
  }
}

}  // namespace
}  // namespace lambert
