#include "lambert/material/make_bsdf.h"

namespace lambert {

Bsdf make_bsdf(const CoatedDiffuseMaterial& m, const ParameterLookup& lookup) {
  const Vec2 alpha = lookup(m.roughness);
  return CoatedDiffuse(clamp(lookup(m.reflectance), 0, 1), m.eta, alpha.x, alpha.y);
}

/// The metal meets the coat, not air: its index is relative to the coat's.
Bsdf make_bsdf(const CoatedConductorMaterial& m, const ParameterLookup& lookup) {
  const Vec2 coat_alpha = lookup(m.interface_roughness), metal_alpha = lookup(m.conductor.roughness);
  const auto [eta, k] = conductor_index(m.conductor, lookup);
  CoatedConductor b;
  b.coat = {m.interface_eta, coat_alpha.x, coat_alpha.y};
  b.metal = {eta / m.interface_eta, k / m.interface_eta, metal_alpha.x, metal_alpha.y};
  return b;
}

}  // namespace lambert
