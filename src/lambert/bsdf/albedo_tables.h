#pragma once
/// Directional albedos by table, computed when first asked for (some milliseconds) and then kept.

#include "lambert/base/vec.h"

namespace lambert {

/// The albedo of single scattering off GGX facets with Fresnel's term f0 + (f90 - f0)(1 - cos)^5 is f0 scale + f90 bias
/// (Karis 2013: the split sum). `alpha` is the slope roughness, cos in [0,1].
struct GgxAlbedo {
  float scale = 1, bias = 0;
  float operator()(float f0, float f90) const { return f0 * scale + f90 * bias; }
};
GgxAlbedo ggx_albedo(float cos_theta, float alpha);
/// Its mean over cosine-distributed directions.
GgxAlbedo ggx_mean_albedo(float alpha);

/// The albedo of white sheen (see sheen.h).
float sheen_albedo(float cos_theta, float roughness);

}  // namespace lambert
