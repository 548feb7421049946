#pragma once
#include "lambert/light/light.h"

namespace lambert {

/// Whether the side of a surface on which `cos_light` (cosine between its normal and the direction that leaves it) lies
/// emits.
inline bool emits(const Emission& e, float cos_light) { return cos_light > 0 || (e.two_sided && cos_light < 0); }

/// Radiance that leaves the surface at `at` from an emitting side.
inline Rgb emitted_radiance(const Emission& e, const LightContext& c, const TextureCoordinates& at) {
  return e.radiance.texture == no_texture ? e.radiance.value : e.radiance.eval(*c.textures, at);
}

/// The mean radiance over the parallelogram of texture coordinates origin + s edge_u + t edge_v. A texture counts for
/// at least 1 % of its factor, so that a light whose bright spot was missed keeps a chance to be chosen.
Rgb mean_emission(const Emission& e, const LightContext& c, Vec2 origin, Vec2 edge_u, Vec2 edge_v);

/// A sample of a surface point under the area measure, made one per solid angle: pdf_omega = pdf_area r² / |cos|. None
/// where the point shows `from` no emitting side. `normal` must be unit.
std::optional<LightSample> area_light_sample(const Emission& e, const LightContext& c, Vec3 from, Vec3 point,
                                             Vec3 normal, const TextureCoordinates& at, float pdf_area);

/// pdf_area r² / |cos|, or 0 where the surface is seen edge on.
float area_to_solid_angle(float pdf_area, Vec3 from, Vec3 point, Vec3 normal);

}  // namespace lambert
