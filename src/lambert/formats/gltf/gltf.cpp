#include "lambert/formats/gltf/cameras.h"
#include "lambert/formats/gltf/document.h"
#include "lambert/formats/gltf/extensions.h"
#include "lambert/formats/gltf/hierarchy.h"
#include "lambert/formats/gltf/instancing.h"
#include "lambert/formats/gltf/lights.h"
#include "lambert/formats/gltf/meshes.h"
#include "lambert/formats/readers.h"

#include <utility>

namespace lambert {
namespace gltf {
namespace {

/// Turns the nodes that a scene shows into a scene graph.
class SceneReader {
 public:
  explicit SceneReader(Document& document)
      : document_(document), hierarchy_(document, document.settings.time), meshes_(document, hierarchy_, graph_) {}

  SceneGraph read() {
    // A stack instead of recursion: a file may nest its nodes a million deep.
    std::vector<std::pair<std::size_t, NodeId>> pending;  // node, its parent in the graph
    const auto push = [&](const std::vector<std::size_t>& nodes, NodeId parent) {
      for (auto it = nodes.rbegin(); it != nodes.rend(); ++it) pending.emplace_back(*it, parent);
    };
    push(roots(), graph_.root());
    while (!pending.empty()) {
      const auto [index, parent] = pending.back();
      pending.pop_back();
      push(hierarchy_.children(index), add_node(index, parent));
    }
    return std::move(graph_);
  }

 private:
  /// Of the default scene, else of the first one, else of all.
  std::vector<std::size_t> roots() const {
    std::vector<std::size_t> nodes;
    const JsonView scenes = document_.root()["scenes"], wanted = document_.root()["scene"];
    if (scenes.size() == 0) {
      for (std::size_t i = 0; i < hierarchy_.size(); ++i)
        if (!hierarchy_.has_parent(i)) nodes.push_back(i);
      return nodes;
    }
    if (scenes.size() > 1)
      document_.notes.add("only one of " + std::to_string(scenes.size()) + " glTF scenes is shown");
    const JsonView scene = wanted ? document_.referred("scenes", wanted) : scenes[std::size_t{0}];
    std::vector<bool> listed(hierarchy_.size());
    for_each(scene["nodes"], [&](const JsonView& reference) {
      document_.referred("nodes", reference);
      const std::size_t node = reference.count();
      if (hierarchy_.has_parent(node)) reference.fail("node " + std::to_string(node) + " is a child of another node");
      if (listed[node]) reference.fail("node " + std::to_string(node) + " is listed twice");
      listed[node] = true;
      nodes.push_back(node);
    });
    return nodes;
  }

  NodeId add_node(std::size_t index, NodeId parent) {
    const JsonView json = document_.root()["nodes"][index];
    const std::string name = json["name"].text("node " + std::to_string(index));
    const NodeId node = graph_.add_node(parent, name, Transform(hierarchy_.pose(index).local()));
    const Mat4& world = hierarchy_.world(index);
    if (json["camera"]) graph_.add_camera(read_camera(document_.referred("cameras", json["camera"]), world));
    if (const JsonView reference = json.extension("KHR_lights_punctual")["light"]) {
      const JsonView light = referred(document_.root().extension("KHR_lights_punctual"), "lights", reference);
      if (auto read = read_light(light, world, document_.notes)) graph_.add_light(*std::move(read));
    }
    add_surfaces(index, node, name);
    return node;
  }

  void add_surfaces(std::size_t index, NodeId node, const std::string& name) {
    std::vector<NodeId> places{node};
    const JsonView json = document_.root()["nodes"][index];
    if (const JsonView instancing = json.extension("EXT_mesh_gpu_instancing")) {
      places.clear();
      for (const Mat4& instance : read_instances(document_, instancing))
        places.push_back(graph_.add_node(node, name + " #" + std::to_string(places.size()), Transform(instance)));
    }
    for (const PlacedSurface& placed : meshes_.of_node(index)) {
      if (placed.in_world) {
        graph_.add_surface(graph_.add_node(graph_.root(), name), placed.surface);
        continue;
      }
      for (const NodeId place : places) {
        if (graph_.world_transform(place).is_singular())
          document_.notes.add("glTF nodes that a scale of 0 flattens are left out");
        else
          graph_.add_surface(place, placed.surface);
      }
    }
  }

  Document& document_;
  Hierarchy hierarchy_;
  SceneGraph graph_;
  Meshes meshes_;
};

}  // namespace
}  // namespace gltf

SceneGraph read_gltf(std::span<const std::byte> data, const std::string& name, const std::filesystem::path& folder,
                     const ReadSettings& settings, Notes& notes) {
  gltf::Document document(data, name, folder, settings, notes);
  gltf::check_version_and_extensions(document);
  return gltf::SceneReader(document).read();
}

}  // namespace lambert
