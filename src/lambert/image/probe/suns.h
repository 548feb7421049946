#pragma once
#include "lambert/image/probe/layout.h"

#include <vector>

namespace lambert::probe {

/// What was taken out of an environment as one light from infinity.
struct Sun {
  Vec3 direction{0, 1, 0};   ///< towards the light
  Rgb irradiance;            ///< on a surface that faces it: W/m² for radiance in W/(m² sr)
  Rgb radiance;              ///< mean over the disk, what it is surrounded by included
  float solid_angle = 0;     ///< sr
  float angular_radius = 0;  ///< of a disk of that solid angle, radians
  float peak = 0;            ///< largest luminance
};

struct SunSettings {
  int most = 1;             ///< suns to look for
  float threshold = 0.05f;  ///< of its peak luminance: what is connected to the peak and above this is the sun's
  float contrast = 20;      ///< a sun's peak is at least so many times the mean luminance of the environment without it
  float largest = 0.1f;     ///< sr: what is larger is no sun
};

struct SunsAndSky {
  std::vector<Sun> suns;  ///< brightest first
  Probe sky;              ///< the environment with the suns' places filled in from around them
};

/// Finds suns (connected texels, across the edges of charts) and takes them out; a place is filled by relaxing it
/// to the Laplace equation, never brighter than it was. What a sun radiates is the difference between the map and the
/// filled one, so that sky and suns together light every surface that sees all of a sun's disk as the map did: to 1e-4
/// where its colour is even. Values must be finite.
SunsAndSky separate_suns(const Probe& probe, const SunSettings& settings = {});

}  // namespace lambert::probe
