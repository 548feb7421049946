#pragma once
#include "lambert/bsdf/bsdf.h"
#include "lambert/bsdf/fresnel.h"

#include <cmath>

namespace lambert {

/// A thin pane: both borders at once, with all reflections between them. Light passes straight on.
///   R' = R + T² R / (1 - R²) = 2R / (1 + R),   T' = 1 - R'
struct ThinDielectric {
  float eta = 1.5f;  ///< index of the pane over that around it

  Rgb eval(Vec3, Vec3, Transport) const { return {}; }
  float pdf(Vec3, Vec3) const { return 0; }
  std::optional<BsdfSample> sample(Vec3 wo, float u_lobe, Vec2, Transport) const {
    if (wo.z == 0) return std::nullopt;
    const float r = fresnel_dielectric(std::abs(wo.z), eta), reflected = 2 * r / (1 + r);
    if (u_lobe < reflected) return BsdfSample{.wi = {-wo.x, -wo.y, wo.z}, .weight = Rgb(1.0f), .specular = true};
    return BsdfSample{.wi = -wo, .weight = Rgb(1.0f), .specular = true, .transmitted = true};
  }
  Rgb albedo(Vec3) const { return Rgb(1.0f); }
  bool is_specular() const { return true; }
};

}  // namespace lambert
