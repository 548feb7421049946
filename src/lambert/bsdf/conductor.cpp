#include "lambert/bsdf/conductor.h"

#include "lambert/bsdf/albedo_tables.h"
#include "lambert/bsdf/fresnel.h"
#include "lambert/bsdf/microfacet.h"

#include <cmath>

namespace lambert {
namespace {

Vec3 upward(Vec3 v) { return v.z < 0 ? -v : v; }

}  // namespace

bool Conductor::is_specular() const { return Ggx::effectively_smooth(alpha_x, alpha_y); }

Rgb Conductor::eval(Vec3 wo, Vec3 wi, Transport) const {
  if (is_specular() || !same_hemisphere(wo, wi)) return {};
  const Vec3 h = upward(normalize(wo + wi));
  const Ggx ggx(alpha_x, alpha_y);
  return fresnel_conductor(std::abs(dot(wo, h)), eta, k) * (ggx.d(h) * ggx.g2(wo, wi) / (4 * std::abs(wo.z)));
}

float Conductor::pdf(Vec3 wo, Vec3 wi) const {
  if (is_specular() || !same_hemisphere(wo, wi)) return 0;
  const Vec3 h = upward(normalize(wo + wi)), w = upward(wo);
  return Ggx(alpha_x, alpha_y).visible_d(w, h) / (4 * std::abs(dot(wo, h)));
}

std::optional<BsdfSample> Conductor::sample(Vec3 wo, float, Vec2 u, Transport mode) const {
  if (wo.z == 0) return std::nullopt;
  if (is_specular())
    return BsdfSample{
        .wi = {-wo.x, -wo.y, wo.z}, .weight = fresnel_conductor(std::abs(wo.z), eta, k), .specular = true};
  const Vec3 h = Ggx(alpha_x, alpha_y).sample_visible(upward(wo), u);
  const Vec3 wi = reflect(wo, wo.z < 0 ? -h : h);
  const float density = pdf(wo, wi);
  if (!same_hemisphere(wo, wi) || !(density > 0)) return std::nullopt;
  return BsdfSample{.wi = wi, .weight = eval(wo, wi, mode) / density, .pdf = density};
}

Rgb Conductor::albedo(Vec3 wo) const {
  if (is_specular()) return fresnel_conductor(std::abs(wo.z), eta, k);
  const GgxAlbedo single = ggx_albedo(std::abs(wo.z), std::sqrt(alpha_x * alpha_y));
  return fresnel_conductor(1, eta, k) * single.scale + Rgb(single.bias);
}

}  // namespace lambert
