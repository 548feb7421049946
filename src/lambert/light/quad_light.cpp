#include "lambert/light/emission.h"
#include "lambert/light/projected_rectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lambert {
namespace {

// Below this solid angle [sr], and nearer to the plane than this part of the longer edge, rounding spoils the spherical
// rectangle; little is lost there by sampling its area.
constexpr float least_solid_angle = 0.004f, least_height = 3e-4f;
// From further away than this many diagonals, r³ varies so little over the rectangle that sampling its area serves as
// well, with no trigonometric function.
constexpr float far_in_diagonals = 2;

std::optional<ProjectedRectangle> good_rectangle(Vec2 corner, Vec2 size) {
  const ProjectedRectangle r(corner, size);
  return r.solid_angle() >= least_solid_angle ? std::optional(r) : std::nullopt;
}

}  // namespace

QuadLight::QuadLight(Vec3 corner, Vec3 edge_u, Vec3 edge_v, const std::array<Vec2, 3>& uv, Emission emission)
    : corner_(corner),
      edge_u_(edge_u),
      edge_v_(edge_v),
      axis_u_(normalize(edge_u)),
      axis_v_(normalize(edge_v)),
      normal_(normalize(cross(edge_u, edge_v))),
      length_u_(length(edge_u)),
      length_v_(length(edge_v)),
      area_(length(cross(edge_u, edge_v))),
      least_height_(least_height * std::max(length_u_, length_v_)),
      far_squared_(sqr(far_in_diagonals) * (sqr(length_u_) + sqr(length_v_))),
      uv_(uv),
      emission_(std::move(emission)) {
  const bool rectangle = std::abs(dot(axis_u_, axis_v_)) < 1e-4f;
  if (!rectangle) least_height_ = std::numeric_limits<float>::infinity();
}

/// The rectangle seen from the reference point; none where its area is to be sampled.
std::optional<ProjectedRectangle> QuadLight::spherical_view(Vec3 to_corner, float height) const {
  const Vec3 to_centre = to_corner + 0.5f * (edge_u_ + edge_v_);
  if (!(std::abs(height) > least_height_) || dot(to_centre, to_centre) > far_squared_) return std::nullopt;
  const float scale = 1 / std::abs(height);
  return good_rectangle(scale * Vec2(dot(to_corner, axis_u_), dot(to_corner, axis_v_)),
                        scale * Vec2(length_u_, length_v_));
}

std::optional<LightSample> QuadLight::sample(const LightContext& c, Vec3 from, Vec2 u) const {
  std::optional<LightSample> result;
  const Vec3 to_corner = corner_ - from;
  const float height = -dot(to_corner, normal_);
  if (!emits(emission_, height)) return result;

  const auto seen = spherical_view(to_corner, height);
  // Lengths along the edges.
  const Vec2 offset = seen ? std::abs(height) * seen->sample(u) : u * Vec2(length_u_, length_v_);
  const Vec3 to_light = to_corner + offset.x * axis_u_ + offset.y * axis_v_;
  LightSample& s = result.emplace();
  s.distance = length(to_light);
  s.wi = to_light * (1 / s.distance);
  // pdf_area r² / |cos|
  s.pdf_omega = seen ? 1 / seen->solid_angle() : s.distance * s.distance * s.distance / (area_ * std::abs(height));
  if (std::isinf(s.pdf_omega)) {
    result.reset();
    return result;
  }
  s.normal = normal_;
  s.radiance = emission_.radiance.value;
  if (emission_.radiance.texture != no_texture) {
    TextureCoordinates at;
    const Vec2 place = offset / Vec2(length_u_, length_v_);
    at.uv = at.uv1 = uv_[0] + place.x * (uv_[1] - uv_[0]) + place.y * (uv_[2] - uv_[0]);
    at.position = from + to_light;
    s.radiance = emission_.radiance.eval(*c.textures, at);
  }
  return result;
}

float QuadLight::pdf_omega(Vec3 from, Vec3 hit) const {
  const Vec3 to_corner = corner_ - from;
  if (const auto seen = spherical_view(to_corner, dot(to_corner, normal_))) return 1 / seen->solid_angle();
  return area_to_solid_angle(1 / area_, from, hit, normal_);
}

LightBounds QuadLight::bounds(const LightContext& c) const {
  LightBounds b;
  for (const Vec3 v : {Vec3(0), edge_u_, edge_v_, edge_u_ + edge_v_}) b.box.add(corner_ + v);
  b.axis = normal_;
  b.cos_theta_o = 1;
  b.two_sided = emission_.two_sided;
  b.intensity = area_ * luminance(mean_emission(emission_, c, uv_[0], uv_[1] - uv_[0], uv_[2] - uv_[0]));
  b.power = pi * b.intensity * (emission_.two_sided ? 2.0f : 1.0f);
  return b;
}

}  // namespace lambert
