#pragma once
#include "lambert/base/rgb.h"

namespace lambert {

/// Reflectance of a thin film over a base: interference of the light reflected above and below it, two orders, turned
/// into RGB by Gaussian fits of the observer's Fourier transform (Belcour and Barla, "A Practical Extension to
/// Microfacet Theory for the Modeling of Varying Iridescence", 2017, in the form of KHR_materials_iridescence,
/// but with Fresnel's exact term at the film's upper side: Schlick's reflects even where there is no border).
/// `thickness_nm` 0 gives the base's Schlick term.
Rgb fresnel_iridescent(float cos_i, float film_ior, float thickness_nm, Rgb base_f0);

}  // namespace lambert
