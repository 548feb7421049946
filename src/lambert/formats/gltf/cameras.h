#pragma once
#include "lambert/camera/camera.h"
#include "lambert/formats/gltf/document.h"

namespace lambert::gltf {

/// `json` is an element of "cameras". The image is 512 pixels high and as wide as the aspect wants, square where the
/// camera leaves it open. Of the node only place and axes count, not its scale.
Camera read_camera(const JsonView& json, const Mat4& world);

}  // namespace lambert::gltf
