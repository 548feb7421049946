#include "lambert/formats/gltf/skin.h"

#include <utility>

namespace lambert::gltf {
namespace {

Mat4 blended_matrix(const std::vector<JointSet>& sets, std::size_t vertex, std::span<const Mat4> joint_matrices,
                    const JsonView& place) {
  Mat4 sum(0);
  float total = 0;
  for (const JointSet& set : sets) {
    for (int c = 0; c < 4; ++c) {
      const float weight = set.weights[vertex][c], joint = set.joints[vertex][c];
      if (weight == 0) continue;
      if (!(joint >= 0 && joint < static_cast<float>(joint_matrices.size())))
        place.fail("vertex " + std::to_string(vertex) + " refers to joint " + std::to_string(joint) +
                   ", but the skin has " + std::to_string(joint_matrices.size()));
      sum += weight * joint_matrices[static_cast<std::size_t>(joint)];
      total += weight;
    }
  }
  return total > 0 ? sum / total : Mat4(1);
}

/// det(m) times the inverse transpose of m, which also exists where m flattens.
Mat3 cofactors(const Mat3& m) { return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])}; }

}  // namespace

void apply_skin(Primitive& primitive, std::span<const Mat4> joint_matrices, const JsonView& place) {
  TriangleMesh& mesh = primitive.mesh;
  bool mirrors = false;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Mat4 m = blended_matrix(primitive.joint_sets, i, joint_matrices, place);
    const Mat3 linear(m);
    const bool mirrored = glm::determinant(linear) < 0;
    if (i == 0) mirrors = mirrored;
    mesh.positions[i] = Vec3(m * Vec4(mesh.positions[i], 1));
    if (!mesh.normals.empty()) mesh.normals[i] = cofactors(linear) * mesh.normals[i] * (mirrored ? -1.0f : 1.0f);
    if (!mesh.tangents.empty()) {
      const float w = mesh.tangents[i].w;
      mesh.tangents[i] = Vec4(linear * Vec3(mesh.tangents[i]), mirrored ? -w : w);
    }
  }
  if (mirrors)
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace lambert::gltf
