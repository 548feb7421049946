#include "lambert/light/emission.h"
#include "lambert/light/sphere_cone.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

float area(const Shape& shape) {
  return std::visit([](const auto& s) { return s.area(); }, shape);
}
ShapeSample sample_area(const Shape& shape, Vec2 u) {
  return std::visit([&](const auto& s) { return s.sample(u); }, shape);
}
bool is_planar(const Shape& shape) {
  return std::holds_alternative<Disk>(shape) || std::holds_alternative<Polygon>(shape);
}

/// dA_world / dA_object at a place with object-space unit normal n under the map M: |det M| |M⁻ᵀ n|.
float area_stretch(const Transform& to_world, Vec3 normal_of_unit_object_normal) {
  return std::abs(glm::determinant(Mat3(to_world.matrix()))) * length(normal_of_unit_object_normal);
}

struct WorldSphere {
  Vec3 centre;
  float radius;
};

/// The sphere in the world, when the shape is a full one and its map a similarity.
std::optional<WorldSphere> world_sphere(const ShapeLight& light) {
  const auto* sphere = std::get_if<Sphere>(light.shape.get());
  if (!sphere || !sphere->is_full()) return std::nullopt;
  const Mat3 m(light.to_world.matrix());
  const float x = length_squared(m[0]), y = length_squared(m[1]), z = length_squared(m[2]);
  const float skew = std::abs(dot(m[0], m[1])) + std::abs(dot(m[1], m[2])) + std::abs(dot(m[2], m[0]));
  if (std::abs(x - y) + std::abs(x - z) + skew > 1e-4f * x) return std::nullopt;
  return WorldSphere{Vec3(light.to_world.matrix()[3]), sphere->radius * std::sqrt(x)};
}

std::optional<SphereCone> cone_seen(const ShapeLight& light, Vec3 from, std::optional<WorldSphere>& sphere) {
  sphere = world_sphere(light);
  return sphere ? SphereCone::from(from, sphere->centre, sphere->radius) : std::nullopt;
}

/// Coordinates of a world point on the shape, found by a short ray against its normal.
Vec2 uv_at(const ShapeLight& light, Vec3 point, Vec3 normal, float scale) {
  const Transform to_object = light.to_world.inverse();
  const Ray ray{to_object.point(point + 0.01f * scale * normal), to_object.vector(-normal)};
  const auto hit = std::visit([&](const auto& s) { return s.intersect(ray); }, *light.shape);
  return hit ? hit->uv : Vec2(0);
}

std::optional<LightSample> sample_sphere(const ShapeLight& light, const LightContext& c, Vec3 from, Vec2 u,
                                         const WorldSphere& sphere, const SphereCone& cone) {
  if (light.reverse_orientation && !light.emission.two_sided) return std::nullopt;
  LightSample s;
  s.normal = cone.sample_normal(u);
  const Vec3 point = sphere.centre + sphere.radius * s.normal;
  s.distance = length(point - from);
  s.wi = (point - from) / s.distance;
  s.pdf_omega = cone.pdf_omega();
  TextureCoordinates at;
  at.position = point;
  if (light.emission.radiance.texture != no_texture) {
    at.uv = at.uv1 = uv_at(light, point, s.normal, sphere.radius);
  }
  s.radiance = emitted_radiance(light.emission, c, at);
  return s;
}

/// The mean over the surface of dA_world / dA_object.
float mean_area_stretch(const ShapeLight& light) {
  constexpr int steps = 16;
  float sum = 0;
  for (int i = 0; i < steps * steps; ++i) {
    const Vec2 u = (Vec2(i % steps, i / steps) + 0.5f) / static_cast<float>(steps);
    sum += area_stretch(light.to_world, light.to_world.normal(sample_area(*light.shape, u).normal));
  }
  return sum / static_cast<float>(steps * steps);
}

}  // namespace

std::optional<LightSample> ShapeLight::sample(const LightContext& c, Vec3 from, Vec2 u) const {
  std::optional<WorldSphere> sphere;
  if (const auto cone = cone_seen(*this, from, sphere)) return sample_sphere(*this, c, from, u, *sphere, *cone);

  const ShapeSample s = sample_area(*shape, u);
  const Vec3 normal = to_world.normal(s.normal);
  const float pdf_area = 1 / (area(*shape) * area_stretch(to_world, normal));
  TextureCoordinates at;
  at.uv = at.uv1 = s.uv;
  at.position = to_world.point(s.position);
  return area_light_sample(emission, c, from, at.position, normalize(reverse_orientation ? -normal : normal), at,
                           pdf_area);
}

/// From the unit world normal m, the object normal is n = Mᵀm / |Mᵀm|, so that |M⁻ᵀn| = 1 / |Mᵀm|.
float ShapeLight::pdf_omega(Vec3 from, Vec3 hit, Vec3 hit_normal) const {
  std::optional<WorldSphere> sphere;
  if (const auto cone = cone_seen(*this, from, sphere)) return cone->pdf_omega();

  const Mat3 m(to_world.matrix());
  const float stretch = std::abs(glm::determinant(m)) / length(glm::transpose(m) * hit_normal);
  return area_to_solid_angle(1 / (area(*shape) * stretch), from, hit, hit_normal);
}

LightBounds ShapeLight::bounds(const LightContext& c) const {
  LightBounds b;
  b.box = to_world.bounds(std::visit([](const auto& s) { return s.bounds(); }, *shape));
  const float radiance = luminance(mean_emission(emission, c, Vec2(0), Vec2(1, 0), Vec2(0, 1)));
  const float world_area = area(*shape) * mean_area_stretch(*this);
  b.power = pi * world_area * radiance * (emission.two_sided ? 2.0f : 1.0f);
  if (is_planar(*shape)) {
    const Vec3 normal = normalize(to_world.normal(sample_area(*shape, Vec2(0.5f)).normal));
    b.axis = reverse_orientation ? -normal : normal;
    b.cos_theta_o = 1;
    b.two_sided = emission.two_sided;
    b.intensity = world_area * radiance;
  } else {
    // A closed convex surface shows on the average a quarter of its area (Cauchy).
    b.intensity = 0.25f * world_area * radiance;
  }
  return b;
}

}  // namespace lambert
