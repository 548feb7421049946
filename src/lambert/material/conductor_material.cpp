#include "lambert/material/make_bsdf.h"

namespace lambert {

ConductorIndex conductor_index(const ConductorMaterial& m, const ParameterLookup& lookup) {
  if (!m.use_reflectance) return {lookup(m.eta), lookup(m.k)};
  return {Rgb(1.0f), conductor_k_of_reflectance(clamp(lookup(m.reflectance), 0, 0.9999f))};
}

Bsdf make_bsdf(const ConductorMaterial& m, const ParameterLookup& lookup) {
  const auto [eta, k] = conductor_index(m, lookup);
  const Vec2 alpha = lookup(m.roughness);
  return Conductor{eta, k, alpha.x, alpha.y};
}

}  // namespace lambert
