#include "lambert/formats/gltf/hierarchy.h"

#include "lambert/formats/gltf/animation.h"

#include <cmath>

namespace lambert::gltf {
namespace {

NodePose read_pose(const JsonView& node) {
  NodePose pose;
  if (const JsonView matrix = node["matrix"]) {
    const std::vector<float> m = matrix.numbers();
    if (m.size() != 16) matrix.fail("expected 16 numbers, found " + std::to_string(m.size()));
    Mat4 columns;
    for (int i = 0; i < 16; ++i) columns[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
    pose.matrix = columns;
  }
  pose.translation = node["translation"].vec3({0, 0, 0});
  pose.scale = node["scale"].vec3({1, 1, 1});
  pose.rotation = rotation_of(node["rotation"].vec4({0, 0, 0, 1}));
  if (node["weights"]) pose.weights = node["weights"].numbers();
  return pose;
}

}  // namespace

glm::quat rotation_of(Vec4 q) {
  const float l = glm::length(q);
  if (!(l > 0)) return {1, 0, 0, 0};
  return {q.w / l, q.x / l, q.y / l, q.z / l};
}

Mat4 NodePose::local() const {
  if (matrix) return *matrix;
  Mat4 m = glm::mat4_cast(rotation);
  for (int i = 0; i < 3; ++i) m[i] *= scale[i];
  m[3] = Vec4(translation, 1);
  return m;
}

Hierarchy::Hierarchy(Document& document, float time) {
  const JsonView nodes = document.root()["nodes"];
  for_each(nodes, [&](const JsonView& node) { poses_.push_back(read_pose(node)); });
  link(nodes);
  apply_animation(document, time, poses_);
  compute_worlds(nodes);
}

void Hierarchy::link(const JsonView& nodes) {
  parents_.assign(size(), none);
  children_.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    for_each(nodes[i]["children"], [&](const JsonView& reference) {
      const std::size_t child = reference.count();
      if (child >= size())
        reference.fail("refers to node " + std::to_string(child) + ", but there are " + std::to_string(size()));
      if (parents_[child] != none) reference.fail("node " + std::to_string(child) + " has a parent already");
      parents_[child] = i;
      children_[i].push_back(child);
    });
  }
}

void Hierarchy::compute_worlds(const JsonView& nodes) {
  // Parents before children: with one parent each, what roots do not reach is in a cycle.
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < size(); ++i)
    if (!has_parent(i)) order.push_back(i);
  worlds_.resize(size());
  std::vector<bool> reached(size());
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::size_t node = order[at];
    worlds_[node] = has_parent(node) ? worlds_[parents_[node]] * poses_[node].local() : poses_[node].local();
    if (!is_finite(worlds_[node])) nodes[node].fail("a number of its transform is not finite");
    reached[node] = true;
    order.insert(order.end(), children_[node].begin(), children_[node].end());
  }
  for (std::size_t i = 0; i < size(); ++i)
    if (!reached[i]) nodes[i].fail("is its own ancestor");
}

}  // namespace lambert::gltf
