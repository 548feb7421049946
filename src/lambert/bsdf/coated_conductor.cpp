#include "lambert/bsdf/coated_conductor.h"

#include "lambert/bsdf/fresnel.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

Vec3 upward(Vec3 v) { return v.z < 0 ? Vec3(v.x, v.y, -v.z) : v; }

/// The direction inside the coat that continues to unit `w` outside, on the same side of the surface.
Vec3 inside_of(Vec3 w, float eta) {
  const Vec3 r(w.x / eta, w.y / eta, 0);
  return {r.x, r.y, std::sqrt(std::max(0.0f, 1 - dot(r, r)))};
}

std::optional<Vec3> outside_of(Vec3 inner, float eta) {
  const Vec3 r(inner.x * eta, inner.y * eta, 0);
  const float squared = dot(r, r);
  if (squared >= 1) return std::nullopt;
  return Vec3(r.x, r.y, std::sqrt(1 - squared));
}

}  // namespace

/// What multiplies the metal's own reflection: passing the coat twice, and the series between.
Rgb CoatedConductor::base(Vec3 wo, Vec3 wi, Vec3 inner_o, Vec3 inner_i) const {
  const float fo = coat.fresnel(wo), fi = coat.fresnel(wi);
  const Rgb r =
      sqrt(fresnel_conductor(inner_o.z, metal.eta, metal.k) * fresnel_conductor(inner_i.z, metal.eta, metal.k));
  return Rgb((1 - fo) * (1 - fi)) / (Rgb(1.0f) - r * std::sqrt(fo * fi));
}

float CoatedConductor::coat_share(Vec3 wo) const {
  const float reflected = coat.fresnel(wo);
  return reflected /
         (reflected + (1 - reflected) * luminance(fresnel_conductor(inside_of(wo, coat.eta).z, metal.eta, metal.k)));
}

Rgb CoatedConductor::eval(Vec3 wo, Vec3 wi, Transport mode) const {
  if (!same_hemisphere(wo, wi)) return {};
  wo = upward(wo), wi = upward(wi);
  const Vec3 io = inside_of(wo, coat.eta), ii = inside_of(wi, coat.eta);
  const Rgb inner = metal.eval(io, ii, mode) * (wi.z / (ii.z * coat.eta * coat.eta));
  return Rgb(coat.eval(wo, wi)) + inner * base(wo, wi, io, ii);
}

/// dω' = dω cos θ / (η² cos θ').
float CoatedConductor::pdf(Vec3 wo, Vec3 wi) const {
  if (!same_hemisphere(wo, wi)) return 0;
  wo = upward(wo), wi = upward(wi);
  const float share = coat_share(wo);
  const Vec3 io = inside_of(wo, coat.eta), ii = inside_of(wi, coat.eta);
  return share * coat.pdf(wo, wi) + (1 - share) * metal.pdf(io, ii) * wi.z / (ii.z * coat.eta * coat.eta);
}

std::optional<BsdfSample> CoatedConductor::sample(Vec3 wo, float u_lobe, Vec2 u, Transport mode) const {
  if (wo.z == 0) return std::nullopt;
  const Vec3 up = upward(wo);
  const float share = coat_share(up), side = wo.z < 0 ? -1.0f : 1.0f;
  BsdfSample s;
  if (u_lobe < share) {
    const auto wi = coat.sample(up, u);
    if (!wi) return std::nullopt;
    s.wi = {wi->x, wi->y, side * wi->z};
    s.specular = coat.is_smooth();
    s.weight = Rgb(coat.fresnel(up) / share);
  } else {
    const Vec3 inner_o = inside_of(up, coat.eta);
    const auto inner = metal.sample(inner_o, u_lobe, u, mode);
    const auto wi = inner ? outside_of(inner->wi, coat.eta) : std::nullopt;
    if (!wi) return std::nullopt;
    s.wi = {wi->x, wi->y, side * wi->z};
    s.specular = metal.is_specular();
    s.weight = inner->weight * base(up, *wi, inner_o, inner->wi) / (1 - share);
  }
  if (s.specular) return s;
  s.pdf = pdf(wo, s.wi);
  if (!(s.pdf > 0)) return std::nullopt;
  s.weight = eval(wo, s.wi, mode) / s.pdf;
  return s;
}

Rgb CoatedConductor::albedo(Vec3 wo) const {
  const Vec3 up = upward(wo), inner = inside_of(up, coat.eta);
  return Rgb(coat.fresnel(up)) + metal.albedo(inner) * base(up, up, inner, inner);
}

}  // namespace lambert
