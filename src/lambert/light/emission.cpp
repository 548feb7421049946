#include "lambert/light/emission.h"

#include <cmath>

namespace lambert {

Rgb mean_emission(const Emission& e, const LightContext& c, Vec2 origin, Vec2 edge_u, Vec2 edge_v) {
  if (e.radiance.texture == no_texture) return e.radiance.value;
  constexpr int steps = 8;
  TextureCoordinates at;
  at.footprint = std::max(length(edge_u), length(edge_v)) / static_cast<float>(steps);
  Rgb sum;
  for (int i = 0; i < steps * steps; ++i) {
    const Vec2 s = (Vec2(i % steps, i / steps) + 0.5f) / static_cast<float>(steps);
    at.uv = at.uv1 = origin + s.x * edge_u + s.y * edge_v;
    sum += e.radiance.eval(*c.textures, at);
  }
  return max(sum / static_cast<float>(steps * steps), 0.01f * e.radiance.value);
}

float area_to_solid_angle(float pdf_area, Vec3 from, Vec3 point, Vec3 normal) {
  const Vec3 to_light = point - from;
  const float squared = length_squared(to_light);
  const float projected = std::abs(dot(normal, to_light));  // r |cos|
  return projected > 0 ? pdf_area * squared * std::sqrt(squared) / projected : 0;
}

std::optional<LightSample> area_light_sample(const Emission& e, const LightContext& c, Vec3 from, Vec3 point,
                                             Vec3 normal, const TextureCoordinates& at, float pdf_area) {
  const Vec3 to_light = point - from;
  const float projected = -dot(normal, to_light);
  if (!emits(e, projected)) return std::nullopt;
  LightSample s;
  s.distance = length(to_light);
  s.wi = to_light / s.distance;
  s.pdf_omega = pdf_area * s.distance * s.distance * s.distance / std::abs(projected);
  if (!(s.pdf_omega > 0) || !std::isfinite(s.pdf_omega)) return std::nullopt;
  s.radiance = emitted_radiance(e, c, at);
  s.normal = normal;
  return s;
}

}  // namespace lambert
