#include "lambert/light/light.h"

namespace lambert {

std::optional<LightSample> PointLight::sample(const LightContext&, Vec3 p, Vec2) const {
  const Vec3 to_light = position - p;
  const float squared = length_squared(to_light);
  if (!(squared > 0)) return std::nullopt;
  LightSample s;
  s.distance = std::sqrt(squared);
  s.wi = to_light / s.distance;
  s.radiance = intensity / squared;
  s.pdf_omega = 1;
  s.delta = true;
  return s;
}

LightBounds PointLight::bounds(const LightContext&) const {
  LightBounds b;
  b.box.add(position);
  b.intensity = luminance(intensity);
  b.power = 4 * pi * b.intensity;
  return b;
}

}  // namespace lambert
