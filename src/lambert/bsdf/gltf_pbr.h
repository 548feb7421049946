#pragma once
#include "lambert/bsdf/bsdf.h"

namespace lambert {

/// The glTF 2.0 metallic-roughness model with its KHR extensions as one mixture of lobes:
///
///   f = sheen + S ( coat + C ( D G2 F / (4 cos cos) + (1 - metallic) B ( (1 - t) diffuse + t transmission ) ) )
///
/// F = lerp(F_dielectric, F_metal, metallic); F_dielectric runs from f0 (ior, specular) to f90 = specular along
/// Fresnel's exact curve, F_metal is Schlick's with f0 the base colour; iridescence replaces both by a thin film's.
/// What the specular lobe takes from the diffuse one is B = (1 - E(wo)) (1 - E(wi)) / (1 - E̅) with its albedo E
/// (Kelemen and Szirmay-Kalos 2001) instead of the specification's 1 - F(wo.h), which reflects more than it gets at
/// grazing directions; coat and sheen take likewise, C = (1 - c F(wo)) (1 - c F(wi)). Reciprocal. Scattering is single:
/// rough metals lose what would reflect again between facets. The diffuse lobe is seen from outside only, unless
/// thin-walled. Local +z is outside.
struct GltfPbr {
  Rgb base_colour{1.0f};
  float metallic = 0;
  float alpha_x = 1,
        alpha_y = 1;  ///< slope roughness along tangent and bitangent: roughness² and KHR_materials_anisotropy
  float ior = 1.5f;
  float specular = 1;
  Rgb specular_colour{1.0f};
  float clearcoat = 0, clearcoat_alpha = 0;
  Rgb sheen_colour{0.0f};
  float sheen_roughness = 0;
  float iridescence = 0, iridescence_ior = 1.3f, iridescence_thickness_nm = 400;
  float transmission = 0;
  bool thin_walled = true;  ///< light passes straight on; else it is refracted

  Rgb eval(Vec3 wo, Vec3 wi, Transport mode) const;
  float pdf(Vec3 wo, Vec3 wi) const;
  std::optional<BsdfSample> sample(Vec3 wo, float u_lobe, Vec2 u, Transport mode) const;
  Rgb albedo(Vec3 wo) const;
  bool is_specular() const;
};

}  // namespace lambert
