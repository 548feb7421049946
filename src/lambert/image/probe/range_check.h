#pragma once
#include "lambert/image/probe/layout.h"

#include <optional>

namespace lambert::probe {

/// What a map holds of the range of its light. Luminances; places that are black or negative do not count as darkest.
struct RangeReport {
  float brightest = 0, darkest = 0;  ///< darkest above 0; 0 when all is black
  float ratio = 0;                   ///< of the two; 0 when all is black
  float stops = 0;                   ///< log2 of it
  Rgb mean_radiance;
  Rgb irradiance_up, irradiance_down;  ///< on horizontal surfaces, facing +y and -y
  /// The plateau: texels that share the brightest value of a channel, to 0.1 %.
  int plateau_texels = 0;
  float plateau_value = 0;        ///< that value
  float plateau_solid_angle = 0;  ///< sr
  Vec3 plateau_direction{0, 1, 0};
  bool clipped = false;  ///< a flat top: 3 texels or more of one value that stands out, or the end of a format's range
  bool at_format_limit = false;  ///< the value is 1 (display formats) or 65504 (half floats)
};
/// Values must be finite.
RangeReport check_range(const Probe& probe);

/// The solid angle of the sun from the earth: a disk of 0.533 degrees.
inline constexpr float sun_solid_angle = 6.8e-5f;

/// A surface whose irradiance is known, as from the photograph of a diffuse ball or card: E = π L / albedo.
struct KnownIrradiance {
  Vec3 normal{0, 1, 0};
  Rgb irradiance;
};
/// By what the plateau's radiance must be multiplied, so that the surface gets its known irradiance: (E - E of all
/// else) / E of the plateau, per channel; none when the surface does not see the plateau or all else is already
/// brighter.
std::optional<Rgb> missing_factor(const Probe& probe, const KnownIrradiance& known);
/// The map with its plateau multiplied.
Probe restored(const Probe& probe, Rgb factor);

}  // namespace lambert::probe
