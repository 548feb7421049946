#include "lambert/scene/scene_graph.h"

#include "lambert/base/error.h"

#include <cassert>

namespace lambert {
namespace {

Bounds3 local_bounds(const Geometry& g) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&g)) return mesh->bounds();
  return std::visit([](const auto& shape) { return shape.bounds(); }, std::get<Shape>(g));
}

}  // namespace

SceneGraph::SceneGraph() { nodes_.push_back({.name = "root"}); }

NodeId SceneGraph::add_node(NodeId parent, std::string label, const Transform& local) {
  assert(parent < nodes_.size());
  const auto id = static_cast<NodeId>(nodes_.size());
  nodes_.push_back({.name = std::move(label), .parent = parent});
  nodes_[parent].children.push_back(id);
  mark_boxes_above(parent);
  set_local_transform(id, local);
  return id;
}

void SceneGraph::mark_boxes_above(NodeId n) {
  for (NodeId above = n; above != no_node && !nodes_[above].bounds_dirty; above = nodes_[above].parent)
    nodes_[above].bounds_dirty = true;
}

void SceneGraph::set_local_transform(NodeId n, const Transform& t) {
  if (!is_finite(t.matrix())) throw Error("node '" + nodes_[n].name + "': a number of its transform is not finite");
  nodes_[n].local = t;
  mark_boxes_above(n);
  // Everything under it moves along; what is dirty already has dirty children.
  std::vector<NodeId> pending{n};
  while (!pending.empty()) {
    Node& node = nodes_[pending.back()];
    pending.pop_back();
    if (node.world_dirty && node.bounds_dirty && &node != &nodes_[n]) continue;
    node.world_dirty = node.bounds_dirty = true;
    pending.insert(pending.end(), node.children.begin(), node.children.end());
  }
}

const Transform& SceneGraph::world_transform(NodeId n) const {
  // The nearest clean ancestor, then down again.
  std::vector<NodeId> path;
  NodeId at = n;
  for (; at != no_node && nodes_[at].world_dirty; at = nodes_[at].parent) path.push_back(at);
  Transform world = at == no_node ? Transform() : nodes_[at].world;
  for (auto it = path.rbegin(); it != path.rend(); ++it) {
    const Node& node = nodes_[*it];
    node.world = world = world * node.local;
    node.world_dirty = false;
  }
  return nodes_[n].world;
}

const Bounds3& SceneGraph::world_bounds(NodeId n) const {
  // Dirty nodes under n in order of depth; recomputed from the deepest up.
  std::vector<NodeId> dirty;
  if (nodes_[n].bounds_dirty) dirty.push_back(n);
  for (std::size_t i = 0; i < dirty.size(); ++i)
    for (const NodeId child : nodes_[dirty[i]].children)
      if (nodes_[child].bounds_dirty) dirty.push_back(child);
  for (auto it = dirty.rbegin(); it != dirty.rend(); ++it) {
    const Node& node = nodes_[*it];
    node.bounds = {};
    for (const Surface& s : node.surfaces) node.bounds.add(world_transform(*it).bounds(geometry_bounds_[s.geometry]));
    for (const NodeId child : node.children) node.bounds.add(nodes_[child].bounds);
    node.bounds_dirty = false;
    ++bounds_recomputed_;
  }
  return nodes_[n].bounds;
}

GeometryId SceneGraph::add_geometry(Geometry g) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&g)) validate(*mesh);
  geometry_bounds_.push_back(local_bounds(g));
  geometries_.push_back(std::move(g));
  return static_cast<GeometryId>(geometries_.size() - 1);
}

void SceneGraph::add_surface(NodeId n, Surface s) {
  assert(s.geometry < geometries_.size());
  nodes_[n].surfaces.push_back(std::move(s));
  mark_boxes_above(n);
}

}  // namespace lambert
