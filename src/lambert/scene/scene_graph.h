#pragma once
/// The mutable scene: what readers fill and editors change. compile() turns it into an immutable Scene for rendering.

#include "lambert/base/bounds.h"
#include "lambert/base/transform.h"
#include "lambert/camera/camera.h"
#include "lambert/geometry/mesh.h"
#include "lambert/geometry/shape.h"
#include "lambert/image/filter/filter_sampler.h"
#include "lambert/light/any_light.h"
#include "lambert/material/material.h"
#include "lambert/texture/texture.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace lambert {

using NodeId = std::uint32_t;
using GeometryId = std::uint32_t;
inline constexpr NodeId no_node = ~NodeId{0};

using Geometry = std::variant<TriangleMesh, Shape>;

/// Geometry with a material: what a node shows. Many surfaces may share one geometry (instances).
struct Surface {
  GeometryId geometry = 0;
  MaterialId material = 0;
  std::optional<Emission> emission;
  bool reverse_orientation = false;  ///< the outward side is the other one
};

/// What a scene file asks of the renderer; the command line overrides it.
struct SceneFileSettings {
  std::optional<int> samples_per_pixel, max_depth;
  std::optional<std::string> sampler, light_strategy, output;
  std::optional<FilterSettings> filter;
};

/// A tree of nodes over pools of shared geometry, textures and materials. World boxes are derived lazily: moving a node
/// marks it, what is under it and the boxes above it dirty (row PG-48).
class SceneGraph {
 public:
  SceneGraph();

  NodeId root() const { return 0; }
  NodeId add_node(NodeId parent, std::string label, const Transform& local = {});
  std::size_t node_count() const { return nodes_.size(); }
  const std::string& node_name(NodeId n) const { return nodes_[n].name; }
  NodeId parent(NodeId n) const { return nodes_[n].parent; }
  const std::vector<NodeId>& children(NodeId n) const { return nodes_[n].children; }
  const Transform& local_transform(NodeId n) const { return nodes_[n].local; }
  void set_local_transform(NodeId n, const Transform& t);
  const Transform& world_transform(NodeId n) const;
  /// Of everything at and under `n`, in world space; recomputed only where dirty.
  const Bounds3& world_bounds(NodeId n) const;
  /// How many boxes world_bounds() has recomputed so far (for tests of the laziness).
  std::size_t bounds_recomputed() const { return bounds_recomputed_; }

  GeometryId add_geometry(Geometry g);  ///< validates a mesh; throws Error
  const Geometry& geometry(GeometryId id) const { return geometries_[id]; }
  std::size_t geometry_count() const { return geometries_.size(); }
  void add_surface(NodeId n, Surface s);
  const std::vector<Surface>& surfaces(NodeId n) const { return nodes_[n].surfaces; }

  /// A light in world space (readers apply the node's transform).
  void add_light(Light l) { lights_.push_back(std::move(l)); }
  const std::vector<Light>& lights() const { return lights_; }
  /// A camera in world space.
  void add_camera(Camera c) { cameras_.push_back(std::move(c)); }
  const std::vector<Camera>& cameras() const { return cameras_; }

  TextureSet textures;
  MaterialSet materials;
  SceneFileSettings settings;
  std::string name;

 private:
  struct Node {
    std::string name;
    Transform local;
    NodeId parent = no_node;
    std::vector<NodeId> children;
    std::vector<Surface> surfaces;
    mutable Transform world;
    mutable Bounds3 bounds;
    mutable bool world_dirty = true, bounds_dirty = true;
  };
  void mark_boxes_above(NodeId n);

  friend class SceneCompiler;  // takes the pools instead of copying them
  std::vector<Node> nodes_;
  std::vector<Geometry> geometries_;
  std::vector<Bounds3> geometry_bounds_;  // in their own space
  std::vector<Light> lights_;
  std::vector<Camera> cameras_;
  mutable std::size_t bounds_recomputed_ = 0;
};

}  // namespace lambert
