#include "lambert/bsdf/layered_interface.h"

#include "lambert/bsdf/fresnel.h"
#include "lambert/bsdf/microfacet.h"

#include <cmath>

namespace lambert {

bool CoatInterface::is_smooth() const { return Ggx::effectively_smooth(alpha_x, alpha_y); }

float CoatInterface::fresnel(Vec3 w) const { return fresnel_dielectric(std::abs(w.z), eta); }

float CoatInterface::eval(Vec3 wo, Vec3 wi) const {
  if (is_smooth()) return 0;
  const Vec3 h = normalize(wo + wi);
  const Ggx ggx(alpha_x, alpha_y);
  return fresnel_dielectric(dot(wo, h), eta) * ggx.d(h) * ggx.g2(wo, wi) / (4 * wo.z);
}

float CoatInterface::pdf(Vec3 wo, Vec3 wi) const {
  if (is_smooth()) return 0;
  const Vec3 h = normalize(wo + wi);
  return Ggx(alpha_x, alpha_y).visible_d(wo, h) / (4 * dot(wo, h));
}

std::optional<Vec3> CoatInterface::sample(Vec3 wo, Vec2 u) const {
  if (is_smooth()) return Vec3(-wo.x, -wo.y, wo.z);
  const Vec3 wi = reflect(wo, Ggx(alpha_x, alpha_y).sample_visible(wo, u));
  if (wi.z <= 0) return std::nullopt;
  return wi;
}

}  // namespace lambert
