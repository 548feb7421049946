#include "lambert/bsdf/iridescence.h"

#include "lambert/base/vec.h"
#include "lambert/bsdf/fresnel.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// The observer's response to a phase 2π OPD: a sum of Gaussians in wave number (paper, supplemental, eq. 10), XYZ to
/// RGB.
Rgb sensitivity(float path_difference_nm, Rgb shift) {
  const float phase = 2 * pi * path_difference_nm * 1e-9f, squared = phase * phase;
  const auto lobe = [&](float value, float position, float variance, float s) {
    return value * std::sqrt(2 * pi * variance) * std::cos(position * phase + s) * std::exp(-squared * variance);
  };
  const float scale = 1 / 1.0685e-7f;
  const float x =
      scale * (lobe(5.4856e-13f, 1.6810e6f, 4.3278e9f, shift.r) + lobe(9.7470e-14f, 2.2399e6f, 4.5282e9f, shift.r));
  const float y = scale * lobe(4.4201e-13f, 1.7953e6f, 9.3046e9f, shift.g);
  const float z = scale * lobe(5.2481e-13f, 2.2084e6f, 6.6121e9f, shift.b);
  return {3.2404542f * x - 1.5371385f * y - 0.4985314f * z, -0.9692660f * x + 1.8760108f * y + 0.0415560f * z,
          0.0556434f * x - 0.2040259f * y + 1.0572252f * z};
}

float smoothstep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace

Rgb fresnel_iridescent(float cos_i, float film_ior, float thickness_nm, Rgb base_f0) {
  // The film fades out below 0.03 nm, so that no film is no film.
  const float film = 1 + (film_ior - 1) * smoothstep(0, 0.03f, thickness_nm);
  const float cos2_t = 1 - (1 - cos_i * cos_i) / (film * film);
  if (cos2_t < 0) return Rgb(1.0f);
  const float cos_t = std::sqrt(cos2_t);

  const float r12 = fresnel_dielectric(cos_i, film), t121 = 1 - r12;
  const float phi21 = film < 1 ? 0 : pi;
  const Rgb f0 = clamp(base_f0, 0, 0.9999f);
  const Rgb base_ior(eta_of_f0(f0.r), eta_of_f0(f0.g), eta_of_f0(f0.b));
  const Rgb r1(f0_of_eta(base_ior.r / film), f0_of_eta(base_ior.g / film), f0_of_eta(base_ior.b / film));
  const Rgb r23 = fresnel_schlick(cos_t, r1, Rgb(1.0f));
  const auto phase = [&](float ior) { return phi21 + (ior < film ? pi : 0.0f); };
  const Rgb phi(phase(base_ior.r), phase(base_ior.g), phase(base_ior.b));

  const float path_difference = 2 * film * thickness_nm * cos_t;
  const Rgb r123 = clamp(r12 * r23, 1e-5f, 0.9999f), root = sqrt(r123);
  const Rgb rs = (t121 * t121) * r23 / (Rgb(1.0f) - r123);
  Rgb total = Rgb(r12) + rs, cm = rs - Rgb(t121);
  for (int m = 1; m <= 2; ++m) {
    cm *= root;
    total += cm * 2.0f * sensitivity(static_cast<float>(m) * path_difference, static_cast<float>(m) * phi);
  }
  return clamp(total, 0, 1);
}

}  // namespace lambert
