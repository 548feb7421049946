#pragma once
#include "lambert/material/material.h"

#include <cmath>

namespace lambert {

/// What make_bsdf's parts look up parameters with.
struct ParameterLookup {
  const TextureSet& textures;
  const MaterialContext& context;

  Rgb operator()(const RgbParameter& p) const { return p.eval(textures, context.at); }
  float operator()(const FloatParameter& p) const { return p.eval(textures, context.at); }
  /// GGX's alpha along x and y.
  Vec2 operator()(const Roughness& r) const {
    const Vec2 value = glm::max(Vec2((*this)(r.u), (*this)(r.v)), Vec2(0));
    return r.remap ? Vec2(std::sqrt(value.x), std::sqrt(value.y)) : value;
  }
  /// Index of refraction at the path's wavelength (Cauchy); η_d itself where there is none.
  float eta(float eta_d, float abbe_number) const;
};

Bsdf make_bsdf(const DiffuseMaterial& m, const ParameterLookup& lookup);
Bsdf make_bsdf(const DiffuseTransmissionMaterial& m, const ParameterLookup& lookup);
Bsdf make_bsdf(const ConductorMaterial& m, const ParameterLookup& lookup);
Bsdf make_bsdf(const DielectricMaterial& m, const ParameterLookup& lookup);
Bsdf make_bsdf(const CoatedDiffuseMaterial& m, const ParameterLookup& lookup);
Bsdf make_bsdf(const CoatedConductorMaterial& m, const ParameterLookup& lookup);
Bsdf make_bsdf(const GltfMaterial& m, const ParameterLookup& lookup);
Bsdf make_bsdf(const MixMaterial& m, const ParameterLookup& lookup);

/// The complex index that a conductor is given, or that of a metal which reflects as it is told: η = 1, k from R.
struct ConductorIndex {
  Rgb eta, k;
};
ConductorIndex conductor_index(const ConductorMaterial& m, const ParameterLookup& lookup);

}  // namespace lambert
