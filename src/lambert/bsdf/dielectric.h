#pragma once
#include "lambert/bsdf/bsdf.h"

namespace lambert {

/// The border of a transparent body: reflection and refraction by Fresnel's equations, smooth or through GGX
/// microfacets (Walter et al. 2007). Local +z is outside.
///   reflection    f = D F G2 / (4 cos θo cos θi)
///   transmission  f = D (1 - F) G2 |wi.h wo.h| / (cos θo cos θi (wi.h + wo.h / η)²), over η² for radiance
/// where η is the index on wi's side over that on wo's, h = ±(wo + η wi).
struct Dielectric {
  float eta = 1.5f;                ///< index inside over outside
  float alpha_x = 0, alpha_y = 0;  ///< slope roughness of GGX

  Rgb eval(Vec3 wo, Vec3 wi, Transport mode) const;
  float pdf(Vec3 wo, Vec3 wi) const;
  std::optional<BsdfSample> sample(Vec3 wo, float u_lobe, Vec2 u, Transport mode) const;
  Rgb albedo(Vec3) const { return Rgb(1.0f); }
  bool is_specular() const;
};

}  // namespace lambert
