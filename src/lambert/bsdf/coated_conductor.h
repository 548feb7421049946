#pragma once
#include "lambert/bsdf/bsdf.h"
#include "lambert/bsdf/conductor.h"
#include "lambert/bsdf/layered_interface.h"

namespace lambert {

/// Metal under a dielectric coat (Weidlich and Wilkie 2007): the metal is met by directions refracted at the flat
/// border, and what the coat reflects back to it is summed as a series:
///   f = coat + (1 - F(wo)) (1 - F(wi)) f_metal(wo', wi') / (η² (1 - R sqrt(F(wo) F(wi))))
/// with R the metal's reflectance at the refracted wo' and wi' (their geometric mean). Exact for a smooth coat over a
/// smooth metal. Reciprocal. Both sides.
struct CoatedConductor {
  CoatInterface coat;
  Conductor metal;  ///< eta and k relative to the coat

  Rgb eval(Vec3 wo, Vec3 wi, Transport) const;
  float pdf(Vec3 wo, Vec3 wi) const;
  std::optional<BsdfSample> sample(Vec3 wo, float u_lobe, Vec2 u, Transport) const;
  Rgb albedo(Vec3 wo) const;
  bool is_specular() const { return coat.is_smooth() && metal.is_specular(); }

 private:
  float coat_share(Vec3 wo) const;
  Rgb base(Vec3 wo, Vec3 wi, Vec3 inner_o, Vec3 inner_i) const;
};

}  // namespace lambert
