#include "lambert/formats/gltf/lights.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cmath>

namespace lambert::gltf {
namespace {

/// Luminous efficacy of monochromatic light of 540 THz (the candela's definition).
constexpr float lumens_per_watt = 683;

SpotLight read_spot(const JsonView& spot) {
  const float inner = spot["innerConeAngle"].number(0), outer = spot["outerConeAngle"].number(pi / 4);
  if (!(inner >= 0 && inner <= outer && outer > 0 && outer <= pi / 2 + 1e-4f))
    spot.fail("expected 0 <= innerConeAngle <= outerConeAngle <= pi / 2");
  SpotLight light;
  light.cos_inner = std::cos(inner);
  light.cos_outer = std::max(std::cos(outer), 0.0f);
  light.falloff = SpotLight::Falloff::gltf;
  return light;
}

}  // namespace

std::optional<Light> read_light(const JsonView& json, const Mat4& world, Notes& notes) {
  const Vec3 colour = glm::clamp(json["color"].vec3({1, 1, 1}), 0.0f, 1.0f);
  const float intensity = std::max(json["intensity"].number(1), 0.0f) / lumens_per_watt;
  const Rgb power = Rgb(colour.x, colour.y, colour.z) * intensity;
  const std::string type = json["type"].text();
  if (json["range"]) notes.add("the range of glTF lights is ignored: they fall off with the square of the distance");
  const Vec3 position(world[3]), axis = -Vec3(world[2]);
  const float l = length(axis);
  const Vec3 direction = l > 0 ? axis / l : Vec3(0, 0, -1);
  if (type != "point" && type != "spot" && type != "directional")
    json["type"].fail("unknown light " + unknown_word(type, {"point", "spot", "directional"}));
  if (is_black(power)) return std::nullopt;
  if (type == "point") return PointLight{position, power};
  if (type == "directional") return DirectionalLight{direction, power};
  SpotLight spot = read_spot(json["spot"]);
  spot.position = position;
  spot.direction = direction;
  spot.intensity = power;
  return spot;
}

}  // namespace lambert::gltf
