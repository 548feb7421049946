#pragma once
/// Spectra in all the ways in which pbrt files give them, turned into RGB.

#include "lambert/formats/pbrt/context.h"
#include "lambert/material/spectrum.h"

namespace lambert::pbrt {

enum class SpectrumRole : std::uint8_t {
  reflectance,  ///< in [0,1]; what lies outside is clamped and noted
  unbounded,    ///< indices of refraction, absorption
  illuminant,   ///< emission
};

/// "rgb", "spectrum" or "blackbody". Of illuminants, "rgb" is linear radiance as it stands; a spectrum or a black body
/// counts by its colour alone, its luminance made 1, since pbrt-v4 divides each light by its spectrum's photometric
/// power (so that "scale" is in nits).
Rgb rgb_value(const Context& context, const Parameter& p, SpectrumRole role);
Rgb rgb_value(const Context& context, const ParameterList& list, std::string_view name, Rgb fallback,
              SpectrumRole role);

/// The index of refraction of a dielectric: a number, a named glass ("glass-BK7") or samples, from which the Abbe
/// number follows.
GlassData index_of_refraction(const Context& context, const ParameterList& list, std::string_view name);

/// Samples of a .spd file: lines of wavelength [nm] and value; `#` starts a comment.
SpectrumSamples read_spd(const std::filesystem::path& path);

}  // namespace lambert::pbrt
