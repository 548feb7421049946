#pragma once
#include "lambert/base/frame.h"
#include "lambert/material/material.h"

namespace lambert {

/// The frame in which `material` scatters: the shading normal `ns` (unit, in `ng`'s hemisphere) bent by the normal map,
/// if there is one, with s along `tangent`, or along the direction of glTF's anisotropy. The map's axes are the
/// tangent, bitangent_sign cross(ns, tangent) and ns.
///
/// A bent or interpolated normal may turn away from a viewer who sees the surface; it is then tilted towards unit `wo`
/// just so far that wo lies 0.02 (a cosine) above it, on the side of `ng` on which wo is. So the frame's z of wo always
/// has the sign of dot(wo, ng).
Frame shading_frame(const Material& material, const TextureSet& textures, const TextureCoordinates& at, Vec3 ng,
                    Vec3 ns, Vec3 tangent, float bitangent_sign, Vec3 wo);

/// The unit normal that tangent-space `texel` (components in [0,1], 0.5 is zero) stands for in the frame (t, b, ns).
Vec3 mapped_normal(Vec3 texel, float scale, Vec3 ns, Vec3 tangent, float bitangent_sign);

}  // namespace lambert
