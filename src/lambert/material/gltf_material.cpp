#include "lambert/material/make_bsdf.h"

#include <algorithm>

namespace lambert {
namespace {

float clamp01(float x) { return std::clamp(x, 0.0f, 1.0f); }

/// Strength of KHR_materials_anisotropy here: the factor times the texture's blue.
float anisotropy_strength(const GltfMaterial& m, const ParameterLookup& lookup) {
  if (m.anisotropy_texture == no_texture) return clamp01(m.anisotropy);
  return clamp01(m.anisotropy * lookup.textures.eval(m.anisotropy_texture, lookup.context.at).z);
}

/// KHR_materials_ior lets 0 stand for a surface that reflects everything (specular-glossiness files).
float index_of_refraction(const GltfMaterial& m, const ParameterLookup& lookup) {
  constexpr float reflects_everything = 1e4f;
  if (m.ior == 0) return reflects_everything;
  const float abbe_number = m.dispersion > 0 ? 20 / m.dispersion : 0;
  return std::max(1.0f, lookup.eta(m.ior, abbe_number));
}

}  // namespace

/// glTF 2.0, appendix B, and the KHR_materials extensions: roughnesses are squared; anisotropy stretches α along the
/// tangent to mix(α, 1, strength²); the film's thickness runs from its minimum to its maximum.
Bsdf make_bsdf(const GltfMaterial& m, const ParameterLookup& lookup) {
  GltfPbr b;
  b.base_colour = clamp(lookup(m.base_colour) * lookup.context.vertex_colour, 0, 1);
  b.metallic = clamp01(lookup(m.metallic));
  const float alpha = sqr(clamp01(lookup(m.roughness)));
  b.alpha_x = b.alpha_y = alpha;
  if (m.anisotropy != 0) b.alpha_x = alpha + (1 - alpha) * sqr(anisotropy_strength(m, lookup));
  b.ior = index_of_refraction(m, lookup);
  b.specular = clamp01(lookup(m.specular));
  b.specular_colour = max(lookup(m.specular_colour), Rgb());
  b.clearcoat = clamp01(lookup(m.clearcoat));
  if (b.clearcoat > 0) b.clearcoat_alpha = sqr(clamp01(lookup(m.clearcoat_roughness)));
  b.sheen_colour = clamp(lookup(m.sheen_colour), 0, 1);
  if (!is_black(b.sheen_colour)) b.sheen_roughness = clamp01(lookup(m.sheen_roughness));
  b.iridescence = clamp01(lookup(m.iridescence));
  if (b.iridescence > 0) {
    const float t = clamp01(lookup(m.iridescence_thickness));
    b.iridescence_ior = m.iridescence_ior;
    b.iridescence_thickness_nm = (1 - t) * m.iridescence_thickness_min + t * m.iridescence_thickness_max;
  }
  b.transmission = clamp01(lookup(m.transmission));
  b.thin_walled = m.thin_walled;
  return b;
}

}  // namespace lambert
