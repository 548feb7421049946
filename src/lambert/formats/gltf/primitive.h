#pragma once
#include "lambert/formats/gltf/document.h"
#include "lambert/geometry/mesh.h"

#include <optional>
#include <span>
#include <vector>

namespace lambert::gltf {

/// JOINTS_n and WEIGHTS_n, per vertex.
struct JointSet {
  std::vector<Vec4> joints;  ///< whole numbers
  std::vector<Vec4> weights;
};

/// A primitive with its morph targets applied, in the mesh's space.
struct Primitive {
  TriangleMesh mesh;
  std::vector<JointSet> joint_sets;
};

/// None for points, lines and primitives without positions, which are noted. `weights` are those of the morph targets;
/// missing ones count as 0.
std::optional<Primitive> read_primitive(Document& document, const JsonView& json, std::span<const float> weights);

/// Unit normals and tangents; normals of length zero are taken from the shape, and tangents without normals dropped.
void repair_directions(TriangleMesh& mesh, Notes& notes);

}  // namespace lambert::gltf
