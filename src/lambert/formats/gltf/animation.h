#pragma once
#include "lambert/formats/gltf/document.h"

#include <vector>

namespace lambert::gltf {

struct NodePose;

/// Puts `poses` (one per node) into the pose that the first animation has `time` seconds after its start; before its
/// first and after its last key it stands still. Further animations are noted.
void apply_animation(Document& document, float time, std::vector<NodePose>& poses);

}  // namespace lambert::gltf
