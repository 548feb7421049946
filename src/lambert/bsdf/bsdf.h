#pragma once
/// Scattering models. All directions are unit, in the local frame (+z the shading normal), and point away from the
/// surface: `wo` to the viewer, `wi` to the light.

#include "lambert/base/rgb.h"
#include "lambert/base/vec.h"

#include <concepts>
#include <cstdint>
#include <optional>

namespace lambert {

/// What travels along wo -> wi: radiance is scaled by 1/η² when it enters a denser medium, importance is not
/// (Veach 1997, sec. 5.2).
enum class Transport : std::uint8_t { radiance, importance };

struct BsdfSample {
  Vec3 wi{0, 0, 1};
  Rgb weight;                ///< f |cos θi| / pdf of the chosen lobe or of all lobes; unbiased either way
  float pdf = 0;             ///< pdf_omega of wi over all lobes [1/sr]; meaningless when specular
  float eta = 1;             ///< relative index of refraction passed through: η of wi's side over η of wo's side
  bool specular = false;     ///< from a Dirac lobe: eval and pdf of (wo, wi) are 0
  bool transmitted = false;  ///< wi lies on the other side
};

/// What every model offers. `eval` is f(wo, wi) |cos θi| [1/sr]; `pdf` the density of sample() in solid angle [1/sr];
/// both 0 for Dirac lobes. `sample` takes three numbers in [0,1); none means absorbed (not an error).
/// `albedo(wo)` estimates ∫ eval dwi for feature images: within some percent for plain models. Regret: for rough
/// dielectrics and coated metals it is far too high (by 0.5 at roughness 1), since it leaves out what single scattering
/// loses; for coats, sheen and films it errs by up to 0.3 either way. The table of bsdf_models_test.cpp bounds each.
/// `is_specular()` is true when every lobe is Dirac: next-event estimation is then useless.
template <class T>
concept BsdfModel = requires(const T& b, Vec3 w, float u, Vec2 u2, Transport t) {
  { b.eval(w, w, t) } -> std::same_as<Rgb>;
  { b.pdf(w, w) } -> std::same_as<float>;
  { b.sample(w, u, u2, t) } -> std::same_as<std::optional<BsdfSample>>;
  { b.albedo(w) } -> std::same_as<Rgb>;
  { b.is_specular() } -> std::same_as<bool>;
};

inline float cos_theta(Vec3 w) { return w.z; }
inline bool same_hemisphere(Vec3 a, Vec3 b) { return a.z * b.z > 0; }

}  // namespace lambert
