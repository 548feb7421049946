#pragma once
#include "lambert/bsdf/bsdf.h"

namespace lambert {

/// Metal: f = D(h) F(wo.h) G2(wo, wi) / (4 cos θo cos θi) (Cook and Torrance 1982; GGX: Walter et al. 2007), or a
/// mirror where it is effectively smooth. Both sides. Light that would reflect again between facets is lost: the albedo
/// falls below F for rough metals.
struct Conductor {
  Rgb eta{0.2f, 0.92f, 1.1f}, k{3.9f, 2.45f, 2.14f};  ///< complex index, relative to outside
  float alpha_x = 0, alpha_y = 0;                     ///< slope roughness of GGX

  Rgb eval(Vec3 wo, Vec3 wi, Transport) const;
  float pdf(Vec3 wo, Vec3 wi) const;
  std::optional<BsdfSample> sample(Vec3 wo, float u_lobe, Vec2 u, Transport) const;
  Rgb albedo(Vec3 wo) const;
  bool is_specular() const;
};

}  // namespace lambert
