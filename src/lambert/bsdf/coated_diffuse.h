#pragma once
#include "lambert/bsdf/bsdf.h"
#include "lambert/bsdf/layered_interface.h"

namespace lambert {

/// Plastic, varnished wood, glazed clay: a dielectric coat, smooth or rough, over a diffuse base. Light that enters is
/// scattered by the base and partly reflected back by the coat from inside, again and again; the series is summed in
/// closed form (Jakob, Mitsuba's plastic, 2010; after Weidlich and Wilkie 2007):
///   f = coat + (1 - F(wo)) (1 - F(wi)) ρ / (π η² (1 - ρ F̄))
/// F̄ is the diffuse reflectance of the coat from inside. Reciprocal; conserves energy. Unlike pbrt's random walk the
/// coat has no thickness and its roughness does not widen what passes through it. Both sides.
struct CoatedDiffuse {
  CoatedDiffuse() : CoatedDiffuse(Rgb(0.5f), 1.5f, 0, 0) {}
  CoatedDiffuse(Rgb base_reflectance, float eta, float alpha_x, float alpha_y);

  Rgb eval(Vec3 wo, Vec3 wi, Transport) const;
  float pdf(Vec3 wo, Vec3 wi) const;
  std::optional<BsdfSample> sample(Vec3 wo, float u_lobe, Vec2 u, Transport) const;
  Rgb albedo(Vec3 wo) const;
  bool is_specular() const { return false; }

 private:
  float coat_share(Vec3 wo) const;
  CoatInterface coat_;
  Rgb base_;       // ρ / (1 - ρ F̄), over η²
  float through_;  // ∫ (1 - F) cos / π over the hemisphere: the mean of what passes the coat
};

}  // namespace lambert
