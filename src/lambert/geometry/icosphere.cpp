#include "lambert/geometry/generators.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace lambert {
namespace {

void icosahedron(std::vector<Vec3>& corners, std::vector<Triangle>& triangles) {
  constexpr float g = std::numbers::phi_v<float>;
  corners = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
             {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& c : corners) c = normalize(c);
  triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
}

void quarter(std::vector<Vec3>& directions, std::vector<Triangle>& triangles) {
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [found, added] = middles.try_emplace(edge, static_cast<std::uint32_t>(directions.size()));
    if (added) directions.push_back(normalize(directions[a] + directions[b]));
    return found->second;
  };
  std::vector<Triangle> finer;
  finer.reserve(4 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  triangles = std::move(finer);
}

/// Longitude and latitude, as uv_sphere has them.
Vec2 uv_of(Vec3 n) {
  const float u = std::atan2(n.x, n.z) / (2 * pi);
  return {u < 0 ? u + 1 : u, 1 - std::acos(std::clamp(n.y, -1.0f, 1.0f)) / pi};
}

/// Gives triangles across u = 0 copies of their vertices with u + 1.
void open_seam(TriangleMesh& mesh) {
  std::unordered_map<std::uint32_t, std::uint32_t> copies;
  for (Triangle& t : mesh.triangles) {
    const auto [least, most] = std::minmax({mesh.uvs[t[0]].x, mesh.uvs[t[1]].x, mesh.uvs[t[2]].x});
    if (most - least <= 0.5f) continue;
    for (std::uint32_t& v : t) {
      if (mesh.uvs[v].x > 0.5f) continue;
      const auto [copy, added] = copies.try_emplace(v, static_cast<std::uint32_t>(mesh.positions.size()));
      if (added) {
        mesh.positions.push_back(Vec3(mesh.positions[v]));
        mesh.normals.push_back(Vec3(mesh.normals[v]));
        mesh.uvs.push_back(mesh.uvs[v] + Vec2(1, 0));
      }
      v = copy->second;
    }
  }
}

}  // namespace

TriangleMesh icosphere(float radius, int subdivisions) {
  assert(subdivisions >= 0 && subdivisions <= 12);
  TriangleMesh mesh;
  icosahedron(mesh.normals, mesh.triangles);
  for (int i = 0; i < subdivisions; ++i) quarter(mesh.normals, mesh.triangles);
  for (const Vec3 n : mesh.normals) {
    mesh.positions.push_back(radius * n);
    mesh.uvs.push_back(uv_of(n));
  }
  open_seam(mesh);
  return mesh;
}

}  // namespace lambert
