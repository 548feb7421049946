#include "lambert/light/environment.h"

#include "lambert/light/environment_map.h"
#include "lambert/light/light_bounds.h"
#include "lambert/sampling/warp.h"

#include <limits>

namespace lambert {

EnvironmentLight::EnvironmentLight(Rgb constant) : scale_(constant) {}

EnvironmentLight::EnvironmentLight(Image image, EnvironmentMapping mapping, Rgb scale, const Transform& to_world)
    : map_(std::make_shared<const EnvironmentMap>(image, mapping)), scale_(scale), to_world_(to_world) {}

Rgb EnvironmentLight::radiance(Vec3 direction) const {
  if (!map_) return scale_;
  return scale_ * map_->radiance(normalize(Vec3(to_world_.inverse_matrix() * Vec4(direction, 0))));
}

float EnvironmentLight::pdf_omega(Vec3 direction) const {
  if (!map_) return uniform_sphere_pdf();
  return map_->pdf_omega(normalize(Vec3(to_world_.inverse_matrix() * Vec4(direction, 0))));
}

std::optional<LightSample> EnvironmentLight::sample(const LightContext&, Vec3, Vec2 u) const {
  LightSample s;
  s.distance = std::numeric_limits<float>::infinity();
  if (map_) {
    const auto found = map_->sample(u);
    if (!found) return std::nullopt;
    s.wi = normalize(to_world_.vector(found->direction));
    s.radiance = scale_ * found->radiance;
    s.pdf_omega = found->pdf_omega;
  } else {
    s.wi = square_to_uniform_sphere(u);
    s.radiance = scale_;
    s.pdf_omega = uniform_sphere_pdf();
  }
  return s;
}

/// What enters the sphere about the scene: π r² ∫ L dω.
LightBounds EnvironmentLight::bounds(const LightContext& c) const {
  LightBounds b;
  const Rgb mean = map_ ? scale_ * map_->mean_radiance() : scale_;
  b.power = scene_disk_area(c) * 4 * pi * luminance(mean);
  return b;
}

}  // namespace lambert
