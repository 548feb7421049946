#pragma once
#include "lambert/formats/gltf/hierarchy.h"
#include "lambert/formats/gltf/materials.h"
#include "lambert/formats/gltf/variants.h"
#include "lambert/scene/scene_graph.h"

#include <map>
#include <utility>
#include <vector>

namespace lambert::gltf {

/// A primitive with its geometry and material in the scene.
struct PlacedSurface {
  Surface surface;
  bool in_world = false;  ///< skinned: where it is does not depend on its node
};

/// The meshes of a document, added to the scene when nodes first ask for them. Nodes that show one mesh in one pose
/// share its geometry.
class Meshes {
 public:
  Meshes(Document& document, const Hierarchy& hierarchy, SceneGraph& graph)
      : document_(&document),
        hierarchy_(&hierarchy),
        graph_(&graph),
        materials_(document, graph.textures, graph.materials),
        variants_(document) {}

  /// What the node with index `node` shows.
  std::vector<PlacedSurface> of_node(std::size_t node);

 private:
  std::vector<PlacedSurface> read(const JsonView& mesh, const std::vector<float>& weights, const JsonView& skin);
  std::vector<Mat4> joint_matrices(const JsonView& skin);

  Document* document_;
  const Hierarchy* hierarchy_;
  SceneGraph* graph_;
  Materials materials_;
  Variants variants_;
  std::map<std::pair<std::size_t, std::vector<float>>, std::vector<PlacedSurface>> unskinned_;
};

}  // namespace lambert::gltf
