#pragma once
#include "lambert/formats/gltf/document.h"
#include "lambert/light/any_light.h"

#include <optional>

namespace lambert::gltf {

/// A light of KHR_lights_punctual in world space; `json` is its object. Candela and lux become W/sr and W/m² by
/// division by 683 lm/W, as Blender's exporter makes them. None when it is black.
std::optional<Light> read_light(const JsonView& json, const Mat4& world, Notes& notes);

}  // namespace lambert::gltf
