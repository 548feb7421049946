#pragma once
#include "lambert/bsdf/bsdf.h"
#include "lambert/sampling/warp.h"

namespace lambert {

/// Ideal diffuse reflection, f = ρ/π (Lambert 1760), on both sides. Conserves energy for ρ <= 1.
struct Diffuse {
  Rgb reflectance{0.5f};

  Rgb eval(Vec3 wo, Vec3 wi, Transport) const {
    return same_hemisphere(wo, wi) ? reflectance * (inv_pi * std::abs(wi.z)) : Rgb();
  }
  float pdf(Vec3 wo, Vec3 wi) const { return same_hemisphere(wo, wi) ? inv_pi * std::abs(wi.z) : 0; }
  std::optional<BsdfSample> sample(Vec3 wo, float, Vec2 u, Transport) const {
    // Built in its place: the compiler copies a returned optional in wider words than it has just written, and waits.
    std::optional<BsdfSample> sample(std::in_place);
    sample->wi = square_to_cosine_hemisphere(u);
    if (wo.z < 0) sample->wi.z = -sample->wi.z;
    sample->weight = reflectance;
    sample->pdf = pdf(wo, sample->wi);
    if (!(sample->pdf > 0)) sample.reset();
    return sample;
  }
  Rgb albedo(Vec3) const { return reflectance; }
  bool is_specular() const { return false; }
};

}  // namespace lambert
