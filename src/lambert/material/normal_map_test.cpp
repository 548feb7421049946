#include "lambert/material/normal_map.h"

#include <gtest/gtest.h>

namespace lambert {
namespace {

constexpr Vec3 z(0, 0, 1), x(1, 0, 0);

void expect_near(Vec3 a, Vec3 b) { EXPECT_NEAR(length(a - b), 0, 1e-5f) << a.x << " " << a.y << " " << a.z; }

TEST(NormalMap, TheFlatTexelKeepsTheNormal) { expect_near(mapped_normal({0.5f, 0.5f, 1}, 1, z, x, 1), z); }

TEST(NormalMap, RedBendsAlongTheTangentAndGreenAlongTheBitangent) {
  expect_near(mapped_normal({1, 0.5f, 1}, 1, z, x, 1), normalize(Vec3(1, 0, 1)));
  expect_near(mapped_normal({0.5f, 1, 1}, 1, z, x, 1), normalize(Vec3(0, 1, 1)));
  expect_near(mapped_normal({0.5f, 1, 1}, 1, z, x, -1), normalize(Vec3(0, -1, 1)));
}

TEST(NormalMap, ScaleFlattensTheBend) { expect_near(mapped_normal({1, 0.5f, 1}, 0, z, x, 1), z); }

TEST(ShadingFrame, FollowsTheMapAndTheTangent) {
  TextureSet textures;
  Material m;
  m.normal_map = textures.add(ConstantTexture{{1, 0.5f, 1, 1}});
  const Frame f = shading_frame(m, textures, {}, z, z, {0, 2, 0}, 1, z);
  expect_near(f.n, normalize(Vec3(0, 1, 1)));
  expect_near(f.t, cross(f.n, f.s));
  EXPECT_NEAR(dot(f.s, Vec3(1, 0, 0)), 0, 1e-6f);
}

TEST(ShadingFrame, TurnsWithTheAnisotropy) {
  TextureSet textures;
  Material m;
  GltfMaterial gltf;
  gltf.anisotropy = 0.5f, gltf.anisotropy_rotation = pi / 2;
  m.model = gltf;
  expect_near(shading_frame(m, textures, {}, z, z, x, 1, z).s, {0, 1, 0});
  expect_near(shading_frame(m, textures, {}, z, z, x, -1, z).s, {0, -1, 0});
  gltf.anisotropy_texture = textures.add(ConstantTexture{{0.5f, 1, 1, 1}});  // along the bitangent; then turned on
  m.model = gltf;
  expect_near(shading_frame(m, textures, {}, z, z, x, 1, z).s, {-1, 0, 0});
}

TEST(ShadingFrame, KeepsTheViewerOnHisSide) {
  const Material m;
  // Seen from grazing angles, an interpolated normal may face away.
  for (const float side : {1.0f, -1.0f}) {
    const Vec3 wo = normalize(Vec3(-1, 0, 0.1f * side));
    const Frame f = shading_frame(m, {}, {}, z, normalize(Vec3(1, 0, 0.3f)), x, 1, wo);
    EXPECT_GT(f.to_local(wo).z * side, 0);
    EXPECT_NEAR(length(f.n), 1, 1e-5f);
  }
}

TEST(ShadingFrame, LeavesAVisibleNormalAlone) {
  const Vec3 ns = normalize(Vec3(0.3f, 0, 1));
  expect_near(shading_frame(Material{}, {}, {}, z, ns, x, 1, z).n, ns);
  expect_near(shading_frame(Material{}, {}, {}, z, ns, x, 1, -z).n, ns);
}

}  // namespace
}  // namespace lambert
