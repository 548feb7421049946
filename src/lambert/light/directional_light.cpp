#include "lambert/light/light.h"
#include "lambert/light/light_bounds.h"

#include <limits>

namespace lambert {

std::optional<LightSample> DirectionalLight::sample(const LightContext&, Vec3, Vec2) const {
  LightSample s;
  s.wi = -direction;
  s.distance = std::numeric_limits<float>::infinity();
  s.radiance = irradiance;
  s.pdf_omega = 1;
  s.delta = true;
  return s;
}

/// The power that passes through the disk that holds the scene.
LightBounds DirectionalLight::bounds(const LightContext& c) const {
  LightBounds b;
  b.axis = direction;
  b.cos_theta_o = 1;
  b.power = scene_disk_area(c) * luminance(irradiance);
  return b;
}

}  // namespace lambert
