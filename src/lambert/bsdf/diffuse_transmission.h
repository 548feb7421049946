#pragma once
#include "lambert/bsdf/bsdf.h"
#include "lambert/sampling/warp.h"

namespace lambert {

/// Diffuse reflection and diffuse transmission through a thin sheet (paper, leaves): f = ρ/π on wo's side, τ/π on the
/// other. Conserves energy for ρ + τ <= 1.
struct DiffuseTransmission {
  Rgb reflectance{0.25f}, transmittance{0.25f};

  Rgb eval(Vec3 wo, Vec3 wi, Transport) const {
    return (same_hemisphere(wo, wi) ? reflectance : transmittance) * (inv_pi * std::abs(wi.z));
  }
  float pdf(Vec3 wo, Vec3 wi) const {
    const float reflected = reflected_share();
    return (same_hemisphere(wo, wi) ? reflected : 1 - reflected) * inv_pi * std::abs(wi.z);
  }
  std::optional<BsdfSample> sample(Vec3 wo, float u_lobe, Vec2 u, Transport) const {
    const float reflected = reflected_share();
    const bool reflects = u_lobe < reflected;
    Vec3 wi = square_to_cosine_hemisphere(u);
    if ((wo.z < 0) == reflects) wi.z = -wi.z;
    const float density = pdf(wo, wi);
    if (!(density > 0)) return std::nullopt;
    const Rgb weight = reflects ? reflectance / reflected : transmittance / (1 - reflected);
    return BsdfSample{.wi = wi, .weight = weight, .pdf = density, .transmitted = !reflects};
  }
  Rgb albedo(Vec3) const { return reflectance + transmittance; }
  bool is_specular() const { return false; }

 private:
  float reflected_share() const {
    const float r = max_component(reflectance), t = max_component(transmittance);
    return r + t > 0 ? r / (r + t) : 0.5f;
  }
};

}  // namespace lambert
