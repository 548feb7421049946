#pragma once
/// The dielectric coat over a base, shared by coated diffuse and coated conductor.

#include "lambert/bsdf/bsdf.h"

namespace lambert {

/// Reflection off the outside of a coat, and what gets through it.
struct CoatInterface {
  float eta = 1.5f;                ///< index of the coat over outside
  float alpha_x = 0, alpha_y = 0;  ///< slope roughness of GGX; smooth: a mirror

  bool is_smooth() const;
  float fresnel(Vec3 w) const;  ///< reflectance of the flat border for light along w, from outside
  /// eval and pdf of the rough reflection alone (0 when smooth), for directions above.
  float eval(Vec3 wo, Vec3 wi) const;
  float pdf(Vec3 wo, Vec3 wi) const;
  /// A reflected direction; none when it goes below the surface.
  std::optional<Vec3> sample(Vec3 wo, Vec2 u) const;
};

}  // namespace lambert
