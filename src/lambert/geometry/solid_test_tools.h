#pragma once
/// What every solid made by sweeping must hold.

#include "lambert/geometry/mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace lambert {

inline Vec3d face_cross(const TriangleMesh& m, const Triangle& t) {
  const Vec3d a(m.positions[t[0]]);
  return cross(Vec3d(m.positions[t[1]]) - a, Vec3d(m.positions[t[2]]) - a);
}

/// Complete arrays, no triangle without area, normals of unit length within a crease of the triangles', textures not
/// mirrored.
inline void expect_sound(const TriangleMesh& mesh) {
  validate(mesh);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3d n = face_cross(mesh, t);
    ASSERT_GT(length(n), 0);
    const Vec2 a = mesh.uvs[t[1]] - mesh.uvs[t[0]], b = mesh.uvs[t[2]] - mesh.uvs[t[0]];
    ASSERT_GT(a.x * b.y - a.y * b.x, 0);
    for (const std::uint32_t v : t) {
      ASSERT_NEAR(length(mesh.normals[v]), 1, 1e-5);
      ASSERT_GT(dot(normalize(n), Vec3d(mesh.normals[v])), 0.5);
    }
  }
}

/// Each edge, known by the positions of its ends, belongs to exactly two triangles, which run through it in opposite
/// directions.
inline void expect_watertight(const TriangleMesh& mesh) {
  ASSERT_TRUE(is_closed(mesh));
  std::map<std::array<float, 6>, int> times;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = mesh.positions[t[i]] + 0.0f, b = mesh.positions[t[(i + 1) % 3]] + 0.0f;
      ++times[{a.x, a.y, a.z, b.x, b.y, b.z}];
    }
  for (const auto& [edge, n] : times) {
    ASSERT_EQ(n, 1);
    ASSERT_TRUE(times.contains({edge[3], edge[4], edge[5], edge[0], edge[1], edge[2]}));
  }
}

}  // namespace lambert
