#pragma once
#include "lambert/base/settings.h"
#include "lambert/image/tonemap/luminance_map.h"

namespace lambert::tone {

/// Fattal, Lischinski, Werman, "Gradient domain high dynamic range compression" (2002): the gradients of log luminance
/// are attenuated, the large ones more, on all scales of a pyramid; the picture is what has these gradients, by a
/// Poisson equation. What differs: gradients count as at least `noise` times alpha, so that flat parts are not
/// amplified without bound. The paper's pictures show the solution as display codes: `contrast` is the power that makes
/// linear light of it. White is where all but `clip` percent of the pixels are below.
struct Fattal {
  static constexpr const char *name = "fattal", *summary = "Fattal 2002: large gradients are attenuated";
  float alpha = 0.1f;  ///< times the mean gradient: the gradient that stays as it is
  float beta = 0.85f;
  float noise = 0.01f;
  float contrast = 2.2f;
  float clip = 0.5f;

  std::vector<Setting> settings() {
    return {{"alpha", "times the mean gradient: what stays as it is; larger is attenuated", &alpha, {}, {}, 0.0f},
            {"beta", "strength: 1 leaves all gradients", &beta, {}, {}, 0.0f, 1.0f},
            {"noise", "times alpha: gradients below are not amplified more", &noise, {}, {}, 0.0f},
            {"contrast", "power on the solution", &contrast, {}, {}, 0.0f, 8.0f},
            {"clip", "percent of the pixels that become white", &clip, {}, 0, {}, 50.0f}};
  }
  Plane map(const LuminanceMap& map) const;
  /// The factors on the gradients of a plane of log luminance.
  Plane attenuation(const Plane& logarithm) const;
};

/// The plane, of mean 0, whose gradients are nearest those of `plane` times the factors (of a face between two pixels:
/// the mean of theirs).
Plane with_scaled_gradients(const Plane& plane, const Plane& factors);

}  // namespace lambert::tone
