#include "lambert/light/light.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// The part of the axis intensity at the angle whose cosine is given; 0 outside the outer cone.
float spot_falloff(const SpotLight& s, float cos_theta) {
  if (cos_theta <= s.cos_outer) return 0;
  if (cos_theta >= s.cos_inner) return 1;
  const float t = (cos_theta - s.cos_outer) / (s.cos_inner - s.cos_outer);
  return s.falloff == SpotLight::Falloff::gltf ? t * t : t * t * (3 - 2 * t);
}

}  // namespace

std::optional<LightSample> SpotLight::sample(const LightContext&, Vec3 p, Vec2) const {
  const Vec3 to_light = position - p;
  const float squared = length_squared(to_light);
  if (!(squared > 0)) return std::nullopt;
  LightSample s;
  s.distance = std::sqrt(squared);
  s.wi = to_light / s.distance;
  const float part = spot_falloff(*this, -dot(s.wi, direction));
  if (part == 0) return std::nullopt;
  s.radiance = intensity * (part / squared);
  s.pdf_omega = 1;
  s.delta = true;
  return s;
}

/// Power: both ramps are polynomials in cos θ, whose means over the ramp are 1/3 and 1/2, so that
/// Φ = 2π I ((1 - cos_inner) + mean (cos_inner - cos_outer)).
LightBounds SpotLight::bounds(const LightContext&) const {
  LightBounds b;
  b.box.add(position);
  b.axis = direction;
  // θ_e is at most a right angle; θ_o takes what is left of a wider cone.
  const float outer = std::acos(cos_outer), theta_e = std::min(outer - std::acos(cos_inner), 0.5f * pi);
  b.cos_theta_o = std::cos(outer - theta_e);
  b.cos_theta_e = std::max(0.0f, std::cos(theta_e));
  b.intensity = luminance(intensity);
  const float mean = falloff == Falloff::gltf ? 1.0f / 3.0f : 0.5f;
  b.power = 2 * pi * b.intensity * ((1 - cos_inner) + mean * (cos_inner - cos_outer));
  return b;
}

}  // namespace lambert
