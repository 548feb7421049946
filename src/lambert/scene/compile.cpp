#include "lambert/base/error.h"
#include "lambert/scene/accelerator.h"
#include "lambert/scene/check_finite.h"
#include "lambert/scene/compiled.h"

#include <algorithm>

namespace lambert {

/// Flattens the tree: every surface with its world transform. Meshes that are placed once are moved out of the graph
/// into world space; those placed several times stay in their own space and are instanced.
class SceneCompiler {
 public:
  explicit SceneCompiler(SceneGraph graph) : graph_(std::move(graph)), state_(std::make_unique<Scene::State>()) {}

  std::unique_ptr<Scene::State> run(const CompileSettings& settings) {
    check_finite(graph_);
    state_->bounds = graph_.world_bounds(graph_.root());
    state_->textures = std::move(graph_.textures);
    state_->materials = std::move(graph_.materials);
    state_->materials.validate();
    state_->lights = std::move(graph_.lights_);
    state_->cameras = std::move(graph_.cameras_);
    state_->settings = std::move(graph_.settings);
    count_uses();
    for (NodeId n = 0; n < graph_.node_count(); ++n)
      for (const Surface& s : graph_.surfaces(n)) place(n, s);

    state_->light_context = {&state_->textures, state_->bounds};
    add_emitters(*state_);
    state_->chooser = LightChooser(state_->lights, state_->light_context, settings.light_strategy);
    state_->accelerator = std::make_unique<Accelerator>(*state_, settings.robust);
    return std::move(state_);
  }

 private:
  void count_uses() {
    uses_.resize(graph_.geometry_count());
    shared_meshes_.resize(graph_.geometry_count());
    shapes_.resize(graph_.geometry_count());
    for (NodeId n = 0; n < graph_.node_count(); ++n)
      for (const Surface& s : graph_.surfaces(n)) ++uses_[s.geometry];
  }

  void place(NodeId n, const Surface& s) {
    const Transform& to_world = graph_.world_transform(n);
    if (to_world.is_singular())
      throw Error("node '" + graph_.node_name(n) + "': its transform flattens space and cannot be undone");
    if (s.material >= state_->materials.size())
      throw Error("node '" + graph_.node_name(n) + "': a surface names material " + std::to_string(s.material) +
                  ", but there are only " + std::to_string(state_->materials.size()));
    CompiledSurface c;
    c.flip = s.reverse_orientation;
    c.material = s.material;
    c.emission = s.emission;
    c.object = object_of(n);
    const Material& material = state_->materials[s.material];
    c.needs_filter = material.alpha_mode != AlphaMode::opaque || !material.double_sided;
    if (auto* mesh = std::get_if<TriangleMesh>(&graph_.geometries_[s.geometry])) {
      place_mesh(c, *mesh, s.geometry, to_world);
    } else {
      auto& shape = shapes_[s.geometry];
      if (!shape) shape = std::make_shared<const Shape>(std::move(std::get<Shape>(graph_.geometries_[s.geometry])));
      c.shape = shape;
      c.to_world = to_world;
    }
    state_->surfaces.push_back(std::move(c));
  }

  void place_mesh(CompiledSurface& c, TriangleMesh& mesh, GeometryId id, const Transform& to_world) {
    auto& shared = shared_meshes_[id];
    c.instanced = uses_[id] > 1;
    if (!shared) {
      TriangleMesh own = c.instanced ? std::move(mesh) : transformed(std::move(mesh), to_world);
      // Embree reads 16 bytes where the last vertex has 12.
      own.positions.reserve(own.positions.size() + 1);
      shared = std::make_shared<const TriangleMesh>(std::move(own));
    }
    c.mesh = shared;
    if (c.instanced) c.to_world = to_world;
    state_->triangle_count += shared->triangles.size();
  }

  std::uint32_t object_of(NodeId n) {
    if (last_object_node_ != n) {
      last_object_node_ = n;
      state_->object_names.push_back(graph_.node_name(n));
    }
    return static_cast<std::uint32_t>(state_->object_names.size() - 1);
  }

  SceneGraph graph_;
  std::unique_ptr<Scene::State> state_;
  std::vector<std::uint32_t> uses_;                                 // per geometry
  std::vector<std::shared_ptr<const TriangleMesh>> shared_meshes_;  // per geometry
  std::vector<std::shared_ptr<const Shape>> shapes_;                // per geometry
  NodeId last_object_node_ = no_node;
};

Scene compile(SceneGraph graph, const CompileSettings& settings) {
  const std::string name = graph.name;
  try {
    return Scene(SceneCompiler(std::move(graph)).run(settings));
  } catch (const Error& e) {
    if (name.empty()) throw;
    throw Error(name + ": " + e.what());
  }
}

}  // namespace lambert
