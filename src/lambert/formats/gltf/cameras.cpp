#include "lambert/formats/gltf/cameras.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cmath>

namespace lambert::gltf {
namespace {

constexpr float default_height = 512;

float positive(const JsonView& json) {
  const float value = json.number();
  if (!(value > 0)) json.fail("expected more than 0");
  return value;
}

Vec2i resolution_of(float aspect) {
  return {static_cast<int>(std::clamp(std::round(default_height * aspect), 1.0f, 16384.0f)),
          static_cast<int>(default_height)};
}

void read_perspective(const JsonView& json, Camera& camera) {
  const float fov = positive(json["yfov"]);
  if (!(fov < pi)) json["yfov"].fail("expected less than pi");
  const float aspect = json["aspectRatio"] ? positive(json["aspectRatio"]) : 1;
  Perspective projection;
  projection.half_height = std::tan(fov / 2);
  projection.half_width = projection.half_height * aspect;
  camera.projection = projection;
  camera.resolution = resolution_of(aspect);
}

void read_orthographic(const JsonView& json, Camera& camera) {
  Orthographic projection;
  // Some exporters write them with a sign.
  projection.half_width = std::abs(json["xmag"].number());
  projection.half_height = std::abs(json["ymag"].number());
  if (!(projection.half_width > 0 && projection.half_height > 0)) json.fail("expected xmag and ymag other than 0");
  camera.projection = projection;
  camera.resolution = resolution_of(projection.half_width / projection.half_height);
}

/// The axes of `world` without their lengths.
Transform unscaled(Mat4 world, const JsonView& place) {
  for (int i = 0; i < 3; ++i) {
    const float l = length(Vec3(world[i]));
    if (!(l > 0)) place.fail("a node shrinks this camera to nothing");
    world[i] /= l;
  }
  const Transform transform(world);
  if (transform.is_singular()) place.fail("a node flattens this camera");
  return transform;
}

}  // namespace

Camera read_camera(const JsonView& json, const Mat4& world) {
  const std::string type = json["type"].text();
  Camera camera;
  camera.name = json["name"].text("");
  camera.to_world = unscaled(world, json);
  if (type == "perspective") {
    read_perspective(json["perspective"], camera);
  } else if (type == "orthographic") {
    read_orthographic(json["orthographic"], camera);
  } else {
    json["type"].fail("unknown camera " + unknown_word(type, {"perspective", "orthographic"}));
  }
  return camera;
}

}  // namespace lambert::gltf
