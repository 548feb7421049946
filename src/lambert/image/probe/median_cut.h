#pragma once
#include "lambert/image/probe/layout.h"

#include <vector>

namespace lambert::probe {

/// A light from infinity that stands for a rectangle of a lat-long map.
struct CutLight {
  Vec3 direction{0, 1, 0};  ///< towards it: the centroid of its light
  Rgb irradiance;           ///< on a surface that faces it: the rectangle's ∫ L dω
  Window texels;            ///< of the lat-long map
};

/// `count` lights of about the same luminous power (Debevec, "A Median Cut Algorithm for Light Probe Sampling", 2005):
/// the brightest rectangle of those that can be cut is halved by power along its longer side, until there are so many,
/// or only single texels and dark ones are left. Their irradiances add up to ∫ L dω of the map, to 1e-5. `lat_long`
/// must be a lat-long map of finite values; throws Error when it is another. Negative light counts as none in the cuts.
std::vector<CutLight> median_cut(const Probe& lat_long, int count);

}  // namespace lambert::probe
