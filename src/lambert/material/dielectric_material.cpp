#include "lambert/material/make_bsdf.h"

namespace lambert {

Bsdf make_bsdf(const DielectricMaterial& m, const ParameterLookup& lookup) {
  if (m.thin) return ThinDielectric{m.eta};
  const Vec2 alpha = lookup(m.roughness);
  return Dielectric{lookup.eta(m.eta, m.abbe_number), alpha.x, alpha.y};
}

}  // namespace lambert
