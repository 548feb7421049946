#pragma once
#include "lambert/base/vec.h"

#include <algorithm>
#include <cmath>

namespace lambert {

/// White sheen (velvet): f = D / (4 (cos θo + cos θi - cos θo cos θi)), with the "Charlie" distribution
/// D(h) = (2 + 1/α) sin(θh)^(1/α) / 2π, α = roughness² (Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF",
/// 2017; visibility: Neubelt and Pettineo 2013). Directions above the surface; without the cosine.
inline float sheen_value(Vec3 wo, Vec3 wi, float roughness) {
  const Vec3 h = normalize(wo + wi);
  const float inverse_alpha = 1 / std::max(roughness * roughness, 1e-3f);
  const float sin2 = std::max(0.0f, 1 - h.z * h.z);
  const float d = (2 + inverse_alpha) * std::pow(sin2, 0.5f * inverse_alpha) * (0.5f * inv_pi);
  return d / (4 * (wo.z + wi.z - wo.z * wi.z));
}

}  // namespace lambert
