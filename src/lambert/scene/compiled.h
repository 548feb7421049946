#pragma once
/// What is inside a compiled scene; only scene/ includes this.

#include "lambert/scene/scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lambert {

/// One surface where it stands: geometry, place, material. Its index is Hit::surface.
struct CompiledSurface {
  std::shared_ptr<const TriangleMesh> mesh;  ///< in world space unless `instanced`; null for shapes
  std::shared_ptr<const Shape> shape;
  Transform to_world;  ///< of shapes and instances
  bool instanced = false;
  bool flip = false;  ///< the outward side is opposite to that of the geometry as placed
  MaterialId material = 0;
  std::optional<Emission> emission;
  std::vector<std::uint32_t> lights;  ///< per primitive; empty when it casts no light
  std::uint32_t object = 0;
  bool needs_filter = false;  ///< alpha or one-sided: rays may pass
};

class Accelerator;

struct Scene::State {
  std::vector<CompiledSurface> surfaces;
  std::vector<std::string> object_names;
  TextureSet textures;
  MaterialSet materials;
  std::vector<Light> lights;
  std::vector<std::uint32_t> environment_lights;
  LightContext light_context;
  LightChooser chooser;
  std::vector<Camera> cameras;
  SceneFileSettings settings;
  Bounds3 bounds;
  std::size_t triangle_count = 0;
  std::unique_ptr<Accelerator> accelerator;
};

/// Three vertices of a triangle in world space, counter-clockwise seen from outside.
struct WorldTriangle {
  std::array<Vec3, 3> p;
  std::array<Vec2, 3> uv;
};
WorldTriangle world_triangle(const CompiledSurface& surface, std::uint32_t primitive);

/// Texture coordinates where a mesh has none: the barycentric ones.
inline Vec2 default_uv(int corner) { return {corner == 1 ? 1.0f : 0.0f, corner == 2 ? 1.0f : 0.0f}; }

/// Whether a ray passes through what it hit: alpha and one-sided surfaces. `ng` in the space of `direction`.
bool ray_passes(const Scene::State& scene, std::uint32_t surface, std::uint32_t primitive, Vec2 barycentric,
                Vec3 origin, Vec3 direction, Vec3 ng);

/// Turns the emissive surfaces into lights.
void add_emitters(Scene::State& scene);

}  // namespace lambert
