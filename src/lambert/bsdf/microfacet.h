#pragma once
#include "lambert/base/vec.h"

#include <limits>

namespace lambert {

/// The GGX distribution of microfacet normals (Walter et al. 2007; anisotropic: Heitz 2014), by the slopes' roughness
/// along x and y. D is normalised so that ∫ D(m) cos θm dm = 1.
class Ggx {
 public:
  /// Values below 1e-4 are raised to it.
  Ggx(float alpha_x, float alpha_y);

  /// So smooth that reflection is taken for a mirror's.
  static bool effectively_smooth(float alpha_x, float alpha_y) { return alpha_x < 1e-3f && alpha_y < 1e-3f; }

  float d(Vec3 m) const;
  float lambda(Vec3 w) const;
  float g1(Vec3 w) const { return 1 / (1 + lambda(w)); }
  /// Masking and shadowing with correlated heights; w on the same or on opposite sides.
  float g2(Vec3 wo, Vec3 wi) const { return 1 / (1 + lambda(wo) + lambda(wi)); }

  /// Density of visible normals: G1(w) max(0, w.m) D(m) / |cos θw|. w above the surface (z > 0).
  float visible_d(Vec3 w, Vec3 m) const;
  /// A normal by visible_d (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023).
  Vec3 sample_visible(Vec3 w, Vec2 u) const;

 private:
  float alpha_x_, alpha_y_;
};

}  // namespace lambert
