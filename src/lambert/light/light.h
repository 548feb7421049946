#pragma once
/// Light sources. Each can be sampled from a point and knows the density with which it does so; densities are per solid
/// angle at that point. Radiance in W/(m² sr).

#include "lambert/base/bounds.h"
#include "lambert/base/rgb.h"
#include "lambert/base/transform.h"
#include "lambert/base/vec.h"
#include "lambert/geometry/shape.h"
#include "lambert/texture/texture.h"

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>

namespace lambert {

class ProjectedRectangle;

/// What a surface emits: `radiance` on the front (and back), uniform over directions.
struct Emission {
  RgbParameter radiance;
  bool two_sided = false;
  bool casts_light = true;  ///< false: seen by the camera and in mirrors only (unlit materials)
};

/// Light that arrives at a reference point.
struct LightSample {
  Vec3 wi{0, 0, 1};     ///< unit, towards the light
  float distance = 0;   ///< to the light; infinity for directional and environment lights
  Rgb radiance;         ///< incoming, unoccluded; for delta lights the irradiance on a facing surface
  float pdf_omega = 0;  ///< 1 for delta lights
  bool delta = false;   ///< cannot be hit by a sampled direction
  Vec3 normal{0};       ///< of the light's surface, zero if it has none: shadow rays end just before it
};

/// The whole scene as lights see it.
struct LightContext {
  const TextureSet* textures = nullptr;  ///< may be null when no emission is textured
  Bounds3 scene_bounds;
};

/// How a light's power spreads, for the light tree (Conty Estevez and Kulla 2018).
struct LightBounds {
  Bounds3 box;             ///< empty for lights at infinity
  Vec3 axis{0, 0, 1};      ///< of the cone of normals
  float cos_theta_o = -1;  ///< the normals' half angle
  float cos_theta_e = 0;   ///< emission beyond the normals
  float power = 0;         ///< luminance of the emitted power [W]
  float intensity = 0;     ///< luminance of the largest radiant intensity [W/sr]; 0 for lights at infinity
  bool two_sided = false;  ///< emits around -axis as well
};

template <class T>
concept LightModel = requires(const T& l, const LightContext& c, Vec3 p, Vec2 u) {
  { l.sample(c, p, u) } -> std::same_as<std::optional<LightSample>>;  // none: nothing arrives
  { l.bounds(c) } -> std::same_as<LightBounds>;
};

struct PointLight {
  Vec3 position{0};
  Rgb intensity{1.0f};  ///< W/sr
  std::optional<LightSample> sample(const LightContext&, Vec3 p, Vec2 u) const;
  LightBounds bounds(const LightContext&) const;
};

struct SpotLight {
  /// glTF's squared ramp (KHR_lights_punctual), or pbrt's smoothstep.
  enum class Falloff : std::uint8_t { gltf, smoothstep };

  Vec3 position{0}, direction{0, 0, -1};
  Rgb intensity{1.0f};  ///< on the axis, W/sr
  float cos_inner = 1, cos_outer = 0.7071f;
  Falloff falloff = Falloff::gltf;
  std::optional<LightSample> sample(const LightContext&, Vec3 p, Vec2 u) const;
  LightBounds bounds(const LightContext&) const;
};

struct DirectionalLight {
  Vec3 direction{0, -1, 0};  ///< in which the light travels, unit
  Rgb irradiance{1.0f};      ///< on a facing surface, W/m²
  std::optional<LightSample> sample(const LightContext&, Vec3 p, Vec2 u) const;
  LightBounds bounds(const LightContext&) const;
};

/// One emitting triangle, sampled by solid angle where it is large and by area where it is small.
struct TriangleLight {
  std::array<Vec3, 3> p;
  std::array<Vec2, 3> uv;
  Emission emission;
  std::optional<LightSample> sample(const LightContext&, Vec3 from, Vec2 u) const;
  /// Density of sample() for the direction to `hit` on this light, seen from `from`.
  float pdf_omega(Vec3 from, Vec3 hit) const;
  LightBounds bounds(const LightContext&) const;
};

/// A parallelogram (two triangles of a mesh joined); rectangles are sampled by solid angle (Ureña et al. 2013) unless
/// they look tiny, others by area. What sampling needs of the shape is computed once.
class QuadLight {
 public:
  /// Normal along cross(edge_u, edge_v). `uv` at corner, corner + edge_u and corner + edge_v.
  QuadLight(Vec3 corner, Vec3 edge_u, Vec3 edge_v, const std::array<Vec2, 3>& uv, Emission emission);

  std::optional<LightSample> sample(const LightContext&, Vec3 from, Vec2 u) const;
  /// Density of sample() for the direction to `hit` on this light, seen from `from`.
  float pdf_omega(Vec3 from, Vec3 hit) const;
  LightBounds bounds(const LightContext&) const;
  const Emission& emission() const { return emission_; }
  Vec3 corner() const { return corner_; }
  Vec3 edge_u() const { return edge_u_; }
  Vec3 edge_v() const { return edge_v_; }

 private:
  std::optional<ProjectedRectangle> spherical_view(Vec3 to_corner, float height) const;

  Vec3 corner_, edge_u_, edge_v_;
  Vec3 axis_u_, axis_v_, normal_;  // of unit length
  float length_u_, length_v_, area_;
  float least_height_;  // nearer to the plane the area is sampled; infinite when this is no rectangle
  float far_squared_;   // of the distance to the centre beyond which the area is sampled
  std::array<Vec2, 3> uv_;
  Emission emission_;
};

/// Any analytic shape under any affine map: by area, and full spheres under similarities by the cone they fill.
struct ShapeLight {
  std::shared_ptr<const Shape> shape;
  Transform to_world;
  bool reverse_orientation = false;
  Emission emission;
  std::optional<LightSample> sample(const LightContext&, Vec3 from, Vec2 u) const;
  /// Density of sample() for the direction to `hit` on this light; `hit_normal` is the surface's unit normal there (its
  /// sign does not matter).
  float pdf_omega(Vec3 from, Vec3 hit, Vec3 hit_normal) const;
  LightBounds bounds(const LightContext&) const;
};

}  // namespace lambert
