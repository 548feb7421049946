#include "lambert/geometry/mesh.h"

#include "lambert/base/error.h"
#include "lambert/geometry/generators.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace lambert {
namespace {

std::string refusal(const std::function<void(TriangleMesh&)>& spoil) {
  TriangleMesh mesh = box(Vec3(0), Vec3(1));
  mesh.name = "crate";
  validate(mesh);
  spoil(mesh);
  try {
    validate(mesh);
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

TEST(ValidateMesh, NamesMeshArrayAndIndex) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal([&](auto& m) { m.positions[7].y = nan; }), "mesh 'crate': positions[7] is not finite");
  EXPECT_EQ(refusal([&](auto& m) { m.normals[0].z = inf; }), "mesh 'crate': normals[0] is not finite");
  EXPECT_EQ(refusal([&](auto& m) { m.uvs[23].x = -inf; }), "mesh 'crate': uvs[23] is not finite");
  EXPECT_EQ(refusal([&](auto& m) { m.colours.resize(5); }),
            "mesh 'crate': colours has 5 entries, expected one for each of 24 positions");
  EXPECT_EQ(refusal([&](auto& m) { m.triangles[3][1] = 24; }),
            "mesh 'crate': triangle 3 names vertex 24, expected less than 24");
}

TEST(ValidateMesh, EmptyMeshIsFine) { EXPECT_NO_THROW(validate(TriangleMesh{})); }

TEST(Mesh, BoundsAndAreaOfABox) {
  const TriangleMesh mesh = box({-1, 0, 2}, {1, 3, 6});
  EXPECT_EQ(mesh.bounds(), (Bounds3{{-1, 0, 2}, {1, 3, 6}}));
  EXPECT_FLOAT_EQ(mesh.area(), 2 * (6 + 8 + 12));
  EXPECT_TRUE(TriangleMesh{}.bounds().empty());
}

/// Normals of triangles and of vertices on the same side.
void expect_normals_along_winding(const TriangleMesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    const Vec3 n = cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
    for (const std::uint32_t v : t) ASSERT_GT(dot(n, mesh.normals[v]), 0);
  }
}

TEST(Mesh, ClosedMeshesHaveAVolume) {
  TriangleMesh mesh = box({1001, -2, -3}, {1002, 2, 3});
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(mesh.volume(), 24, 1e-3f);
  mesh.triangles[0] = {mesh.triangles[0][0], mesh.triangles[0][2], mesh.triangles[0][1]};
  EXPECT_FALSE(is_closed(mesh));
  mesh.triangles.erase(mesh.triangles.begin());
  EXPECT_FALSE(is_closed(mesh));
  mesh.triangles = {{0, 1, 1}, {1, 0, 0}};
  EXPECT_FALSE(is_closed(mesh));
  EXPECT_EQ(TriangleMesh{}.volume(), 0);
}

TEST(TransformedMesh, MirroredTrianglesTurnRound) {
  const Transform mirror = Transform::scale({-2, 1, 0.5f}) * Transform::rotate(degrees(30), {1, 2, 3});
  const TriangleMesh mesh = transformed(uv_sphere(1, 24, 12), mirror);
  ASSERT_TRUE(mirror.swaps_handedness());
  expect_normals_along_winding(mesh);
  for (const Vec3 n : mesh.normals) EXPECT_NEAR(length(n), 1, 1e-5);
}

TEST(TransformedMesh, BitangentMovesWithTheSurface) {
  TriangleMesh mesh = grid(1, 1);
  mesh.tangents.assign(mesh.positions.size(), Vec4(1, 0, 0, 1));
  const auto bitangent = [](const TriangleMesh& m) {
    return m.tangents[0].w * cross(m.normals[0], Vec3(m.tangents[0]));
  };
  const Vec3 before = bitangent(mesh);
  for (const Transform& t : {Transform::scale({1, -1, 1}), Transform::scale({1, 1, -1}), Transform::scale({-1, 1, 1}),
                             Transform::rotate(degrees(50), {1, 1, 0})})
    EXPECT_LT(length(bitangent(transformed(mesh, t)) - t.vector(before)), 1e-5f);
}

TEST(TransformedMesh, FlattenedMeshStaysFinite) {
  EXPECT_NO_THROW(validate(transformed(uv_sphere(1, 8, 4), Transform::scale({1, 0, 1}))));
}

TEST(SmoothNormals, OfAFineSphereAreRadial) {
  TriangleMesh mesh = icosphere(2, 4);
  const std::vector<Vec3> exact = mesh.normals;
  mesh.uvs.clear();
  compute_smooth_normals(mesh);
  std::size_t close = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) close += length(mesh.normals[i] - exact[i]) < 0.01f;
  EXPECT_GT(static_cast<double>(close), 0.9 * static_cast<double>(exact.size()));  // not at the seam, which is open
}

/// A cube's corner normal is its diagonal however its faces are cut, since angles count and not triangles.
TEST(SmoothNormals, AreWeightedByAngle) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back(Bounds3{Vec3(-1), Vec3(1)}.corner(i));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  compute_smooth_normals(mesh);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_LT(length(mesh.normals[i] - normalize(mesh.positions[i])), 1e-5f);
}

TEST(SmoothNormals, DegenerateTrianglesAndLooseVerticesGiveUnitNormals) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}};
  compute_smooth_normals(mesh);
  for (const Vec3 n : mesh.normals) EXPECT_EQ(length(n), 1);
}

}  // namespace
}  // namespace lambert
