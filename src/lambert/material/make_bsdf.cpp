#include "lambert/material/make_bsdf.h"

#include "lambert/material/spectrum.h"

#include <cassert>

namespace lambert {

float ParameterLookup::eta(float eta_d, float abbe_number) const {
  return context.wavelength_nm > 0 ? cauchy_eta(eta_d, abbe_number, context.wavelength_nm) : eta_d;
}

Bsdf make_bsdf(const MixMaterial&, const ParameterLookup&) {
  assert(!"a mix must be resolved first (MaterialSet::resolve)");
  return {};
}

Bsdf make_bsdf(const Material& material, const TextureSet& textures, const MaterialContext& context) {
  const ParameterLookup lookup{textures, context};
  return std::visit([&](const auto& model) { return make_bsdf(model, lookup); }, material.model);
}

bool is_dispersive(const Material& material) {
  if (const auto* d = std::get_if<DielectricMaterial>(&material.model)) return d->abbe_number > 0 && !d->thin;
  if (const auto* g = std::get_if<GltfMaterial>(&material.model)) {
    return g->dispersion > 0 && g->transmission.value > 0 && !g->thin_walled;
  }
  return false;
}

}  // namespace lambert
