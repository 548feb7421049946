#pragma once
#include "lambert/formats/gltf/document.h"

#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace lambert::gltf {

/// Where a node is in its parent, and the weights of its mesh's morph targets.
struct NodePose {
  std::optional<Mat4> matrix;  ///< instead of the other three
  Vec3 translation{0}, scale{1};
  glm::quat rotation{1, 0, 0, 0};
  std::optional<std::vector<float>> weights;

  Mat4 local() const;
};

/// The rotation that the file's (x, y, z, w) means, made unit; none for zero.
glm::quat rotation_of(Vec4 xyzw);

/// All nodes of a document, whether a scene shows them or not, in the pose of a moment.
class Hierarchy {
 public:
  /// Throws Error at the place where a node has two parents or is its own ancestor.
  Hierarchy(Document& document, float time);

  std::size_t size() const { return poses_.size(); }
  const NodePose& pose(std::size_t node) const { return poses_[node]; }
  const std::vector<std::size_t>& children(std::size_t node) const { return children_[node]; }
  bool has_parent(std::size_t node) const { return parents_[node] != none; }
  const Mat4& world(std::size_t node) const { return worlds_[node]; }

 private:
  static constexpr std::size_t none = ~std::size_t{0};
  void link(const JsonView& nodes);
  void compute_worlds(const JsonView& nodes);

  std::vector<NodePose> poses_;
  std::vector<std::size_t> parents_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<Mat4> worlds_;
};

}  // namespace lambert::gltf
