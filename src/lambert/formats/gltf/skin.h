#pragma once
#include "lambert/formats/gltf/primitive.h"

#include <span>
#include <vector>

namespace lambert::gltf {

/// Moves every vertex by the weighted mean of its joints' matrices (linear blend skinning, glTF 2.0 section 3.7.3). A
/// vertex without weight stays where it is. Throws Error at `place` when a joint is out of range.
void apply_skin(Primitive& primitive, std::span<const Mat4> joint_matrices, const JsonView& place);

}  // namespace lambert::gltf
