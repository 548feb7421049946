#pragma once
#include "lambert/light/light.h"

namespace lambert {

/// The smallest bounds this can find that hold both; powers and intensities add up.
LightBounds merge(const LightBounds& a, const LightBounds& b);

/// An estimate of the irradiance that lights within `b` cause at `point` on a surface with unit `normal` (either side
/// counts; a zero normal counts all directions), with every angle at its most favourable: 0 only if there is none.
/// Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018, eq. 3.
float importance(const LightBounds& b, Vec3 point, Vec3 normal);

/// M_Ω, the orientation term of the surface area orientation heuristic (ibid., eq. 1).
float orientation_measure(const LightBounds& b);

/// π r² of the sphere about the scene; that of a unit sphere when the scene is empty.
inline float scene_disk_area(const LightContext& c) {
  const float radius = c.scene_bounds.radius();
  return radius > 0 ? pi * radius * radius : pi;
}

}  // namespace lambert
