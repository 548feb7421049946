#pragma once
/// Reflection at the border of two media.

#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"

#include <optional>

namespace lambert {

/// Unpolarised reflectance of a dielectric border for light that arrives at cosine `cos_i` (negative: from inside),
/// with `eta` the index inside over that outside. 1 beyond the critical angle.
float fresnel_dielectric(float cos_i, float eta);

/// Unpolarised reflectance of a conductor with index eta + i k (relative to the medium outside), per channel; cos_i in
/// [0,1].
Rgb fresnel_conductor(float cos_i, Rgb eta, Rgb k);

/// Schlick 1994: F0 + (F90 - F0) (1 - cos)^5.
inline float schlick_weight(float cos_i) {
  const float m = std::min(1.0f, std::max(0.0f, 1 - cos_i)), m2 = m * m;
  return m2 * m2 * m;
}
inline Rgb fresnel_schlick(float cos_i, Rgb f0, Rgb f90) { return lerp(f0, f90, schlick_weight(cos_i)); }

/// Reflectance at normal incidence, and the index (above 1) that has it.
inline float f0_of_eta(float eta) { return sqr((eta - 1) / (eta + 1)); }
inline float eta_of_f0(float f0) {
  const float root = std::sqrt(std::min(f0, 0.9999f));
  return (1 + root) / (1 - root);
}

/// k for which a conductor with index `eta` = 1 reflects `reflectance` at normal incidence (in [0,1)).
Rgb conductor_k_of_reflectance(Rgb reflectance);

/// The share of diffuse light (cosine-distributed) that a smooth dielectric border reflects, for light from outside;
/// by quadrature of fresnel_dielectric. `eta` may be below 1 (light from inside).
float diffuse_fresnel(float eta);

/// The refracted direction of unit `w` (pointing away from the border) about unit `n` on w's side; `eta` is the index
/// of the other side over that of w's. None beyond the critical angle.
std::optional<Vec3> refract(Vec3 w, Vec3 n, float eta);
inline Vec3 reflect(Vec3 w, Vec3 n) { return 2 * dot(w, n) * n - w; }

}  // namespace lambert
