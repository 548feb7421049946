#pragma once
#include "lambert/formats/gltf/document.h"

#include <vector>

namespace lambert::gltf {

/// Where the copies of EXT_mesh_gpu_instancing stand in their node; `json` is the extension's object. Throws Error when
/// its attributes have different lengths.
std::vector<Mat4> read_instances(Document& document, const JsonView& json);

}  // namespace lambert::gltf
