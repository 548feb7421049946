#include "lambert/scene/compiled.h"

#include <cmath>

namespace lambert {
namespace {

bool near(Vec2 a, Vec2 b) { return length(a - b) < 1e-4f; }

/// The parallelogram that two triangles of a mesh form, if they do: the second has the shared edge backwards, its free
/// corner completes the first, and texture coordinates go on across the edge.
std::optional<QuadLight> joined(const WorldTriangle& a, const WorldTriangle& b, const Emission& emission) {
  const float size = length(a.p[1] - a.p[0]) + length(a.p[2] - a.p[0]);
  const auto same = [&](Vec3 p, Vec3 q) { return length(p - q) < 1e-5f * size; };
  for (std::size_t i = 0; i < 3; ++i) {
    // The corner of `a` opposite the shared edge, then counter-clockwise.
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    const Vec3 corner = a.p[i], u = a.p[i1] - corner, v = a.p[i2] - corner;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      if (!same(b.p[j], corner + u + v) || !same(b.p[j1], a.p[i2]) || !same(b.p[j2], a.p[i1])) continue;
      const bool uvs_go_on =
          near(b.uv[j1], a.uv[i2]) && near(b.uv[j2], a.uv[i1]) && near(b.uv[j], a.uv[i1] + a.uv[i2] - a.uv[i]);
      if (!uvs_go_on && emission.radiance.texture != no_texture) return std::nullopt;
      return QuadLight(corner, u, v, {a.uv[i], a.uv[i1], a.uv[i2]}, emission);
    }
  }
  return std::nullopt;
}

float twice_area(const WorldTriangle& t) { return length(cross(t.p[1] - t.p[0], t.p[2] - t.p[0])); }

/// A light per triangle, or per two that follow each other and form a parallelogram.
void add_mesh(CompiledSurface& s, std::vector<Light>& lights) {
  const auto count = static_cast<std::uint32_t>(s.mesh->triangles.size());
  s.lights.assign(count, no_light);
  for (std::uint32_t i = 0; i < count; ++i) {
    const WorldTriangle t = world_triangle(s, i);
    if (!(twice_area(t) > 0)) continue;
    s.lights[i] = static_cast<std::uint32_t>(lights.size());
    if (i + 1 < count) {
      if (auto quad = joined(t, world_triangle(s, i + 1), *s.emission)) {
        s.lights[++i] = static_cast<std::uint32_t>(lights.size());
        lights.emplace_back(std::move(*quad));
        continue;
      }
    }
    lights.emplace_back(TriangleLight{t.p, t.uv, *s.emission});
  }
}

}  // namespace

void add_emitters(Scene::State& scene) {
  for (CompiledSurface& s : scene.surfaces) {
    if (!s.emission || !s.emission->casts_light || is_black(s.emission->radiance.value)) continue;
    if (s.mesh) {
      add_mesh(s, scene.lights);
    } else {
      s.lights = {static_cast<std::uint32_t>(scene.lights.size())};
      scene.lights.emplace_back(ShapeLight{s.shape, s.to_world, s.flip, *s.emission});
    }
  }
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i)
    if (std::holds_alternative<EnvironmentLight>(scene.lights[i])) scene.environment_lights.push_back(i);
}

}  // namespace lambert
