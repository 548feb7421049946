#include "lambert/bsdf/dielectric.h"

#include "lambert/bsdf/fresnel.h"
#include "lambert/bsdf/microfacet.h"

#include <cmath>

namespace lambert {
namespace {

Vec3 upward(Vec3 v) { return v.z < 0 ? -v : v; }

/// The facet that turns wo into wi, and how.
struct Facet {
  Vec3 h{0, 0, 1};  // on the upper side
  float eta = 1;    // of wi's side over wo's; 1 for reflection
  bool reflects = true;
  bool possible = false;
};

Facet facet_between(Vec3 wo, Vec3 wi, float eta_inside) {
  Facet f;
  f.reflects = same_hemisphere(wo, wi);
  f.eta = f.reflects ? 1.0f : (wo.z > 0 ? eta_inside : 1 / eta_inside);
  const Vec3 h = wi * f.eta + wo;
  if (wo.z == 0 || wi.z == 0 || h == Vec3(0)) return f;
  f.h = upward(normalize(h));
  // Facets seen from behind reflect and refract nothing.
  f.possible = dot(f.h, wi) * wi.z > 0 && dot(f.h, wo) * wo.z > 0;
  return f;
}

}  // namespace

bool Dielectric::is_specular() const { return eta == 1 || Ggx::effectively_smooth(alpha_x, alpha_y); }

Rgb Dielectric::eval(Vec3 wo, Vec3 wi, Transport mode) const {
  if (is_specular()) return {};
  const Facet f = facet_between(wo, wi, eta);
  if (!f.possible) return {};
  const Ggx ggx(alpha_x, alpha_y);
  const float fresnel = fresnel_dielectric(dot(wo, f.h), eta), dg = ggx.d(f.h) * ggx.g2(wo, wi);
  if (f.reflects) return Rgb(fresnel * dg / (4 * std::abs(wo.z)));
  const float wi_h = dot(wi, f.h), wo_h = dot(wo, f.h), denominator = wi_h + wo_h / f.eta;
  const float value = (1 - fresnel) * dg * std::abs(wi_h * wo_h / (denominator * denominator * wo.z));
  return Rgb(mode == Transport::radiance ? value / (f.eta * f.eta) : value);
}

float Dielectric::pdf(Vec3 wo, Vec3 wi) const {
  if (is_specular()) return 0;
  const Facet f = facet_between(wo, wi, eta);
  if (!f.possible) return 0;
  const Vec3 up = upward(wo), h = f.h;
  const float visible = Ggx(alpha_x, alpha_y).visible_d(up, h), fresnel = fresnel_dielectric(dot(wo, h), eta);
  if (f.reflects) return visible * fresnel / (4 * std::abs(dot(wo, h)));
  const float denominator = dot(wi, h) + dot(wo, h) / f.eta;
  return visible * (1 - fresnel) * std::abs(dot(wi, h)) / (denominator * denominator);
}

std::optional<BsdfSample> Dielectric::sample(Vec3 wo, float u_lobe, Vec2 u, Transport mode) const {
  if (wo.z == 0) return std::nullopt;
  const bool smooth = is_specular();
  const Vec3 m = smooth ? Vec3(0, 0, 1) : Ggx(alpha_x, alpha_y).sample_visible(upward(wo), u);
  const Vec3 towards = wo.z < 0 ? -m : m;  // the facet's normal on wo's side
  const float fresnel = fresnel_dielectric(dot(wo, m), eta);
  BsdfSample s;
  s.transmitted = u_lobe >= fresnel;
  if (s.transmitted) {
    s.eta = wo.z > 0 ? eta : 1 / eta;
    const auto refracted = refract(wo, towards, s.eta);
    if (!refracted || refracted->z * wo.z >= 0) return std::nullopt;
    s.wi = *refracted;
  } else {
    s.wi = reflect(wo, towards);
    if (!same_hemisphere(wo, s.wi)) return std::nullopt;
  }
  if (smooth) {
    s.specular = true;
    s.weight = Rgb(s.transmitted && mode == Transport::radiance ? 1 / (s.eta * s.eta) : 1.0f);
    return s;
  }
  s.pdf = pdf(wo, s.wi);
  if (!(s.pdf > 0)) return std::nullopt;
  s.weight = eval(wo, s.wi, mode) / s.pdf;
  return s;
}

}  // namespace lambert
