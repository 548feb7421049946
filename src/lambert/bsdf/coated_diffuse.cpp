#include "lambert/bsdf/coated_diffuse.h"

#include "lambert/bsdf/fresnel.h"
#include "lambert/sampling/warp.h"

#include <cmath>

namespace lambert {
namespace {

/// diffuse_fresnel, remembered for the last index that this thread asked for: nearly all coats of a scene share one.
float cached_diffuse_fresnel(float eta) {
  thread_local float last_eta = 0, last_value = 0;
  if (eta != last_eta) last_eta = eta, last_value = diffuse_fresnel(eta);
  return last_value;
}

Vec3 upward(Vec3 v) { return v.z < 0 ? Vec3(v.x, v.y, -v.z) : v; }

}  // namespace

/// F̄ inside = 1 - (1 - F̄ outside) / η², since the border passes as much one way as the other.
CoatedDiffuse::CoatedDiffuse(Rgb base_reflectance, float eta, float alpha_x, float alpha_y)
    : coat_{eta, alpha_x, alpha_y} {
  through_ = 1 - cached_diffuse_fresnel(eta);
  const float inside = 1 - through_ / (eta * eta);
  base_ = base_reflectance / ((Rgb(1.0f) - base_reflectance * inside) * (eta * eta));
}

float CoatedDiffuse::coat_share(Vec3 wo) const {
  const float coat = coat_.fresnel(wo), base = (1 - coat) * through_ * luminance(base_);
  return coat + base > 0 ? coat / (coat + base) : 0;
}

Rgb CoatedDiffuse::eval(Vec3 wo, Vec3 wi, Transport) const {
  if (!same_hemisphere(wo, wi)) return {};
  wo = upward(wo), wi = upward(wi);
  const Rgb diffuse = base_ * ((1 - coat_.fresnel(wo)) * (1 - coat_.fresnel(wi)) * inv_pi * wi.z);
  return Rgb(coat_.eval(wo, wi)) + diffuse;
}

float CoatedDiffuse::pdf(Vec3 wo, Vec3 wi) const {
  if (!same_hemisphere(wo, wi)) return 0;
  wo = upward(wo), wi = upward(wi);
  const float share = coat_share(wo);
  return share * coat_.pdf(wo, wi) + (1 - share) * cosine_hemisphere_pdf(wi);
}

std::optional<BsdfSample> CoatedDiffuse::sample(Vec3 wo, float u_lobe, Vec2 u, Transport mode) const {
  if (wo.z == 0) return std::nullopt;
  const Vec3 up = upward(wo);
  const float share = coat_share(up), side = wo.z < 0 ? -1.0f : 1.0f;
  const bool coat = u_lobe < share;
  const auto wi = coat ? coat_.sample(up, u) : std::optional(square_to_cosine_hemisphere(u));
  if (!wi) return std::nullopt;
  BsdfSample s;
  s.wi = {wi->x, wi->y, side * wi->z};
  if (coat && coat_.is_smooth()) {
    s.specular = true;
    s.weight = Rgb(coat_.fresnel(up) / share);
    return s;
  }
  s.pdf = pdf(wo, s.wi);
  if (!(s.pdf > 0)) return std::nullopt;
  s.weight = eval(wo, s.wi, mode) / s.pdf;
  return s;
}

Rgb CoatedDiffuse::albedo(Vec3 wo) const {
  const float coat = coat_.fresnel(wo);
  return Rgb(coat) + base_ * ((1 - coat) * through_);
}

}  // namespace lambert
