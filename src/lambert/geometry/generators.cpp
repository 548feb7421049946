#include "lambert/geometry/generators.h"

#include <cassert>
#include <cmath>
#include <functional>

namespace lambert {
namespace {

struct PatchPoint {
  Vec3 position, normal;
};

/// A grid of vertices over [0,1]², one row and column more than cells; (du x dv) points outward.
TriangleMesh patch(int columns, int rows, const std::function<PatchPoint(float u, float v)>& at) {
  assert(columns > 0 && rows > 0);
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(columns + 1);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const Vec2 uv(static_cast<float>(i) / static_cast<float>(columns),
                    static_cast<float>(j) / static_cast<float>(rows));
      const PatchPoint p = at(uv.x, uv.y);
      mesh.positions.push_back(p.position);
      mesh.normals.push_back(p.normal);
      mesh.uvs.push_back(uv);
    }
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const std::uint32_t a = j * n + i, b = a + 1, c = a + n, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

Vec3 knot_centre(float p, float q, float t) {
  const float r = std::cos(q * t) + 2;
  return {r * std::cos(p * t), r * std::sin(p * t), -std::sin(q * t)};
}

}  // namespace

TriangleMesh grid(float width, float depth, int columns, int rows) {
  return patch(columns, rows, [=](float u, float v) {
    return PatchPoint{{(u - 0.5f) * width, 0, (0.5f - v) * depth}, {0, 1, 0}};
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
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const Vec2 uv : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
        mesh.positions.push_back(corner + uv.x * u + uv.y * v);
        mesh.normals.push_back(normal);
        mesh.uvs.push_back(uv);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  return mesh;
}

TriangleMesh uv_sphere(float radius, int around, int along) {
  return patch(around, along, [=](float u, float v) {
    const float phi = 2 * pi * u, theta = pi * (1 - v);
    const Vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
    return PatchPoint{radius * n, n};
  });
}

TriangleMesh torus(float major_radius, float minor_radius, int around, int across) {
  return patch(around, across, [=](float u, float v) {
    const float phi = 2 * pi * u, theta = 2 * pi * v;
    const Vec3 out(std::sin(phi), 0, std::cos(phi));
    const Vec3 n = std::cos(theta) * out + Vec3(0, std::sin(theta), 0);
    return PatchPoint{major_radius * out + minor_radius * n, n};
  });
}

TriangleMesh torus_knot(int p, int q, int along, int around) {
  const auto fp = static_cast<float>(p), fq = static_cast<float>(q);
  return patch(along, around, [=](float u, float v) {
    // The frame of the curve from a point slightly ahead: exact enough, and smooth.
    const float t = 2 * pi * u, angle = 2 * pi * v;
    const Vec3 a = knot_centre(fp, fq, t), b = knot_centre(fp, fq, t + 1e-2f);
    const Vec3 tangent = normalize(b - a), binormal = normalize(cross(tangent, a + b)),
               normal = cross(binormal, tangent);
    const Vec3 n = std::cos(angle) * normal + std::sin(angle) * binormal;
    return PatchPoint{a + 0.45f * n, n};
  });
}

}  // namespace lambert
