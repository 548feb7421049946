#include "lambert/camera/camera.h"

#include "lambert/sampling/warp.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// A ray in camera space, and the width of a pixel there.
struct LocalRay {
  Vec3 origin{0};
  Vec3 direction{0, 0, -1};
  float pixel_width = 0;   // at the origin
  float pixel_spread = 0;  // per unit of the direction's length
};

/// Film point to [-1,1] x [-1,1], y up.
Vec2 normalised(Vec2 film, Vec2i resolution) {
  return {2 * film.x / static_cast<float>(resolution.x) - 1, 1 - 2 * film.y / static_cast<float>(resolution.y)};
}

/// A point on the lens, and the ray from there to where the pinhole's ray (through `origin` along `direction`, whose
/// z is -1) meets the plane of focus.
void refocus(LocalRay& ray, float lens_radius, float focal_distance, Vec2 u) {
  const Vec2 lens = lens_radius * square_to_uniform_disk_concentric(u);
  const Vec3 focus = ray.origin + focal_distance * ray.direction;
  ray.origin += Vec3(lens, 0);
  ray.direction = (focus - ray.origin) / focal_distance;
}

struct MakeRay {
  Vec2 film;
  Vec2i resolution;
  Vec2 u_lens;

  LocalRay operator()(const Perspective& p) const {
    const Vec2 s = normalised(film, resolution);
    LocalRay ray;
    ray.direction = {p.centre.x + s.x * p.half_width, p.centre.y + s.y * p.half_height, -1};
    ray.pixel_spread = 2 * p.half_height / static_cast<float>(resolution.y);
    if (p.lens_radius > 0) refocus(ray, p.lens_radius, p.focal_distance, u_lens);
    return ray;
  }
  LocalRay operator()(const Orthographic& o) const {
    const Vec2 s = normalised(film, resolution);
    LocalRay ray;
    ray.origin = {o.centre.x + s.x * o.half_width, o.centre.y + s.y * o.half_height, 0};
    ray.pixel_width = 2 * o.half_height / static_cast<float>(resolution.y);
    if (o.lens_radius > 0) refocus(ray, o.lens_radius, o.focal_distance, u_lens);
    return ray;
  }
  LocalRay operator()(const Panoramic&) const {
    const float phi = 2 * pi * (film.x / static_cast<float>(resolution.x) - 0.5f);
    const float theta = pi * film.y / static_cast<float>(resolution.y);
    LocalRay ray;
    ray.direction = {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
    ray.pixel_spread = pi / static_cast<float>(resolution.y);
    return ray;
  }
};

}  // namespace

Perspective perspective(Angle fov, FovAxis axis, Vec2i resolution) {
  const float half = std::tan(0.5f * fov.radians());
  const auto width = static_cast<float>(resolution.x), height = static_cast<float>(resolution.y);
  const bool by_height = axis == FovAxis::vertical || (axis == FovAxis::shorter && height <= width);
  Perspective p;
  p.half_height = by_height ? half : half * height / width;
  p.half_width = by_height ? half * width / height : half;
  return p;
}

bool Camera::has_lens() const {
  struct HasLens {
    bool operator()(const Perspective& p) const { return p.lens_radius > 0; }
    bool operator()(const Orthographic& o) const { return o.lens_radius > 0; }
    bool operator()(const Panoramic&) const { return false; }
  };
  return std::visit(HasLens{}, projection);
}

CameraRay Camera::ray(Vec2 film, Vec2 u_lens, float u_time) const {
  const LocalRay local = std::visit(MakeRay{film, resolution, u_lens}, projection);
  CameraRay r;
  r.ray.origin = to_world.point(local.origin);
  const Vec3 direction = to_world.vector(local.direction);
  const float local_length = length(local.direction), world_length = length(direction);
  r.ray.direction = direction * (1 / world_length);
  r.ray.time = shutter_open + u_time * (shutter_close - shutter_open);
  r.cone = {local.pixel_width * world_length / local_length, local.pixel_spread / local_length};
  return r;
}

Camera Camera::with_resolution(Vec2i r) const {
  Camera c = *this;
  const float change = static_cast<float>(r.x) / static_cast<float>(r.y) * static_cast<float>(resolution.y) /
                       static_cast<float>(resolution.x);
  if (auto* p = std::get_if<Perspective>(&c.projection)) p->half_width *= change;
  if (auto* o = std::get_if<Orthographic>(&c.projection)) o->half_width *= change;
  c.resolution = r;
  return c;
}

float Camera::axis_depth(const Ray& ray, float t) const {
  if (std::holds_alternative<Panoramic>(projection)) return t;
  return t * dot(ray.direction, -normalize(to_world.vector({0, 0, 1})));
}

Camera framing_camera(const Bounds3& bounds, Vec2i resolution) {
  constexpr float part_of_image = 0.92f;
  const Vec3 centre = bounds.empty() ? Vec3(0) : bounds.centre();
  const Vec3 back = normalize(Vec3(0.35f, 0.3f, 1));
  const Perspective lens = perspective(degrees(40), FovAxis::shorter, resolution);
  // A corner at (x, y, z) from the centre, z towards the camera, is in the image when |x| <= half_width (distance - z),
  // and so in y.
  const Transform to_camera = Transform::look_at(back, Vec3(0), {0, 1, 0}).inverse();
  float distance = 0;
  for (int i = 0; i < 8 && !bounds.empty(); ++i) {
    const Vec3 corner = to_camera.vector(bounds.corner(i) - centre);
    const float sideways = std::max(std::abs(corner.x) / lens.half_width, std::abs(corner.y) / lens.half_height);
    distance = std::max(distance, corner.z + sideways / part_of_image);
  }
  if (!(distance > 0)) distance = 1;
  Camera c;
  c.name = "framing";
  c.resolution = resolution;
  c.projection = lens;
  c.to_world = Transform::look_at(centre + back * distance, centre, {0, 1, 0});
  return c;
}

}  // namespace lambert
