#include "lambert/material/make_bsdf.h"

namespace lambert {

Bsdf make_bsdf(const DiffuseMaterial& m, const ParameterLookup& lookup) {
  return Diffuse{clamp(lookup(m.reflectance), 0, 1)};
}

/// Where both together exceed 1 they are scaled down, so that no energy is made.
Bsdf make_bsdf(const DiffuseTransmissionMaterial& m, const ParameterLookup& lookup) {
  const Rgb r = max(lookup(m.reflectance), Rgb()), t = max(lookup(m.transmittance), Rgb());
  const Rgb sum = max(r + t, Rgb(1.0f));
  return DiffuseTransmission{r / sum, t / sum};
}

}  // namespace lambert
