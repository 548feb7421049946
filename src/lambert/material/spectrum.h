#pragma once
/// Spectra turned into linear Rec. 709 RGB through the CIE 1931 observer, and the data of named metals and glasses.

#include "lambert/base/rgb.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lambert {

/// CIE 1931 2° colour matching functions at a wavelength [nm] (multi-lobe fit of Wyman, Sloan and Shirley 2013).
struct Xyz {
  float x = 0, y = 0, z = 0;
};
Xyz cie_1931(float wavelength_nm);
Rgb xyz_to_rgb(Xyz c);

/// Samples (wavelength [nm], value), in order of wavelength; linear between, constant outside.
using SpectrumSamples = std::vector<std::pair<float, float>>;

/// Reflectance or index of refraction under an equal-energy illuminant: a constant spectrum c gives (c, c, c).
Rgb spectrum_to_reflectance_rgb(const SpectrumSamples& s);
/// Emission: ∫ s(λ) x̄ȳz̄ dλ / ∫ ȳ dλ as RGB; a constant spectrum c gives the colour of equal-energy white times c.
Rgb spectrum_to_emission_rgb(const SpectrumSamples& s);
/// Planck's law scaled so that its maximum is 1 (pbrt's blackbody).
SpectrumSamples blackbody(float kelvin);

/// The weight of a wavelength in an RGB path: non-negative and with mean (1, 1, 1) over sample_wavelength's choices.
Rgb wavelength_rgb(float wavelength_nm);
float sample_wavelength(float u);  ///< in [380, 720] nm

/// Complex index of refraction of a metal in RGB ("Ag", "Al", "Au", "Cu", "CuZn", "MgO", "TiO2", …).
struct MetalData {
  Rgb eta, k;
};
std::optional<MetalData> named_metal(std::string_view name);
std::vector<std::string> metal_names();
/// Index at 587.6 nm and Abbe number of a glass ("BK7", "BAF10", "FK51A", "LASF9", "SF5", "SF10", "SF11", "diamond",
/// "water", …).
struct GlassData {
  float eta = 1.5f, abbe_number = 0;
};
std::optional<GlassData> named_glass(std::string_view name);
std::vector<std::string> glass_names();
/// Cauchy's η(λ) = A + B/λ² through η_d at 587.6 nm and the Abbe number.
float cauchy_eta(float eta_d, float abbe_number, float wavelength_nm);

}  // namespace lambert
