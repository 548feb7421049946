#pragma once
/// The immutable scene that methods render.

#include "lambert/base/frame.h"
#include "lambert/base/ray.h"
#include "lambert/camera/camera.h"
#include "lambert/light/any_light.h"
#include "lambert/light/light_choice.h"
#include "lambert/material/material.h"
#include "lambert/scene/scene_graph.h"
#include "lambert/texture/texture.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace lambert {

inline constexpr std::uint32_t no_light = ~std::uint32_t{0};

/// What a ray meets first, before anything is interpolated.
struct Hit {
  float t = 0;
  Vec2 barycentric{0};        ///< of the triangle's 2nd and 3rd vertex; uv of analytic shapes
  std::uint32_t surface = 0;  ///< index into the compiled surfaces
  std::uint32_t primitive = 0;
  Vec3 ng{0, 0, 1};  ///< not normalised, in the space of the geometry, on its own side
};

/// A point on a surface with everything that shading needs.
struct SurfacePoint {
  Vec3 position{0};
  Vec3 ng{0, 0, 1};       ///< geometric normal, unit, outward
  Vec3 ns{0, 0, 1};       ///< shading normal, unit, in ng's hemisphere; normal map not yet applied
  Vec3 tangent{1, 0, 0};  ///< along +u, not normalised
  float bitangent_sign = 1;
  Vec2 uv{0}, uv1{0};
  Vec4 colour{1};           ///< vertex colour and alpha
  float uv_per_length = 0;  ///< how much uv changes per scene unit along the surface, for texture footprints
  MaterialId material = 0;  ///< may be a mix
  std::uint32_t surface = 0, object = 0, primitive = 0;
  std::uint32_t light = no_light;
};

struct CompileSettings {
  LightStrategy light_strategy = LightStrategy::tree;
  bool robust = false;  ///< watertight intersection (Embree's robust mode), slower
};

class Scene {
 public:
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  /// Nearest hit in [t_min, t_max]; surfaces with alpha let rays pass by a hash of ray and primitive. Thread-safe.
  bool intersect(const Ray& ray, Hit& hit) const;
  /// Whether anything lies in [t_min, t_max].
  bool occluded(const Ray& ray) const;
  SurfacePoint surface_point(const Ray& ray, const Hit& hit) const;

  /// Radiance leaving `point` towards unit `wo`, from its own emission; black where it does not emit.
  Rgb emitted(const SurfacePoint& point, Vec3 wo) const;
  /// False for emission that is only seen directly (unlit materials).
  bool casts_light(const SurfacePoint& point) const;
  /// Density (per solid angle) with which sampling light `point.light` from `from` would have found `point`; without
  /// the probability of choosing that light.
  float light_pdf_omega(const SurfacePoint& point, Vec3 from) const;
  /// All radiance from infinity along unit `direction`.
  Rgb environment_radiance(Vec3 direction) const;

  const std::vector<Light>& lights() const;
  const std::vector<std::uint32_t>& environment_lights() const;  ///< indices into lights()
  const LightChooser& light_chooser() const;
  const LightContext& light_context() const;
  const MaterialSet& materials() const;
  const TextureSet& textures() const;
  const std::vector<Camera>& cameras() const;
  const SceneFileSettings& settings() const;
  const Bounds3& bounds() const;
  std::size_t triangle_count() const;  ///< counting each instance
  std::string object_name(std::uint32_t object) const;

  struct State;  ///< see compiled.h

 private:
  friend Scene compile(SceneGraph graph, const CompileSettings& settings);
  explicit Scene(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Consumes the graph. Throws Error when a number in it is not finite or a material is wrong, naming the node.
Scene compile(SceneGraph graph, const CompileSettings& settings = {});

/// Of the camera of a scene that has none, unless another is asked for.
inline constexpr Vec2i default_resolution{1280, 720};

/// Adds a camera that sees the whole scene at `resolution` when there is none, and a studio environment when there is
/// no light; says so in `notes`. Another aspect than that of `resolution` may cut the scene off.
void add_missing_camera_and_light(SceneGraph& graph, class Notes& notes, Vec2i resolution = default_resolution);

}  // namespace lambert
