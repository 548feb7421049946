#include "lambert/geometry/generators.h"

#include "lambert/geometry/unit_circle.h"

#include <cassert>
#include <cmath>
#include <functional>

namespace lambert {
namespace {

struct PatchPoint {
  Vec3 position, normal;
};

Vec2 circle(float turns) { return Vec2(unit_circle(static_cast<double>(turns))); }

/// A grid of vertices over [0,1]², one row and column more than cells; ∂p/∂u × ∂p/∂v points outward. Triangles that a
/// pole collapses are left out.
TriangleMesh patch(int columns, int rows, const std::function<PatchPoint(float u, float v)>& at) {
  assert(columns > 0 && rows > 0);
  TriangleMesh mesh;
  const auto w = static_cast<std::uint32_t>(columns), h = static_cast<std::uint32_t>(rows);
  const std::size_t vertices = (std::size_t{w} + 1) * (std::size_t{h} + 1);
  mesh.positions.reserve(vertices), mesh.normals.reserve(vertices), mesh.uvs.reserve(vertices);
  mesh.triangles.reserve(std::size_t{2} * w * h);
  for (std::uint32_t j = 0; j <= h; ++j)
    for (std::uint32_t i = 0; i <= w; ++i) {
      const Vec2 uv(static_cast<float>(i) / static_cast<float>(w), static_cast<float>(j) / static_cast<float>(h));
      const PatchPoint p = at(uv.x, uv.y);
      mesh.positions.push_back(p.position), mesh.normals.push_back(p.normal), mesh.uvs.push_back(uv);
    }
  const std::vector<Vec3>& p = mesh.positions;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) mesh.triangles.push_back({a, b, c});
  };
  for (std::uint32_t j = 0; j < h; ++j)
    for (std::uint32_t i = 0; i < w; ++i) {
      const std::uint32_t a = j * (w + 1) + i, b = a + 1, c = a + w + 1, d = c + 1;
      add(a, b, d);
      add(a, d, c);
    }
  return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const Triangle& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace

TriangleMesh grid(float width, float depth, int columns, int rows) {
  return patch(columns, rows, [=](float u, float v) {
    return PatchPoint{{(u - 0.5f) * width, 0, (0.5f - v) * depth}, {0, 1, 0}};
  });
}

TriangleMesh disk(float radius, int around) {
  return patch(around, 1, [=](float u, float v) {
    const Vec2 c = circle(u) * (radius * (1 - v));
    return PatchPoint{{c.y, 0, c.x}, {0, 1, 0}};
  });
}

TriangleMesh box(Vec3 min, Vec3 max) {
  TriangleMesh mesh;
  const Vec3 size = max - min;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      Vec3 corner = min, u(0), v(0), normal(0);
      if (upper) corner[axis] = max[axis];
      normal[axis] = upper ? 1.0f : -1.0f;
      // (axis, axis + 1, axis + 2) is right-handed; the lower face turns the other way.
      const int a = (axis + (upper ? 1 : 2)) % 3, b = (axis + (upper ? 2 : 1)) % 3;
      u[a] = size[a], v[b] = size[b];
      append(mesh, patch(1, 1, [&](float s, float t) { return PatchPoint{corner + s * u + t * v, normal}; }));
    }
  return mesh;
}

TriangleMesh uv_sphere(float radius, int around, int along) {
  return patch(around, along, [=](float u, float v) {
    const Vec2 phi = circle(u), theta = circle(0.5f * (1 - v));
    const Vec3 n(theta.y * phi.y, theta.x, theta.y * phi.x);
    return PatchPoint{radius * n, n};
  });
}

TriangleMesh cone(float radius, float height, int around) {
  TriangleMesh mesh = patch(around, 1, [=](float u, float v) {
    const Vec2 phi = circle(u);
    const Vec3 out(phi.y, 0, phi.x);
    return PatchPoint{radius * (1 - v) * out + Vec3(0, v * height, 0), normalize(height * out + Vec3(0, radius, 0))};
  });
  append(mesh, transformed(disk(radius, around), Transform::scale({1, -1, 1})));
  return mesh;
}

TriangleMesh torus(float major_radius, float minor_radius, int around, int across) {
  return patch(around, across, [=](float u, float v) {
    const Vec2 phi = circle(u), theta = circle(v);
    const Vec3 out(phi.y, 0, phi.x), n = theta.x * out + Vec3(0, theta.y, 0);
    return PatchPoint{major_radius * out + minor_radius * n, n};
  });
}

TriangleMesh torus_knot(int p, int q, int along, int around) {
  constexpr float major_radius = 2, tube_radius = 0.45f;
  const auto fp = static_cast<float>(p), fq = static_cast<float>(q);
  return patch(along, around, [=](float u, float v) {
    const Vec2 phi = circle(fp * u), theta = circle(fq * u), angle = circle(v);
    // On the torus about the curve the outward normal is across the curve: with it the frame closes without a twist.
    const Vec3 out(phi.x, phi.y, 0), round(-phi.y, phi.x, 0), up(0, 0, -1);
    const Vec3 normal = theta.x * out + theta.y * up, centre = major_radius * out + normal;
    const Vec3 tangent = normalize(fp * (major_radius + theta.x) * round + fq * (theta.x * up - theta.y * out));
    const Vec3 n = angle.x * normal + angle.y * cross(normal, tangent);
    return PatchPoint{centre + tube_radius * n, n};
  });
}

}  // namespace lambert
