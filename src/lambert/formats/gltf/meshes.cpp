#include "lambert/formats/gltf/meshes.h"

#include "lambert/formats/gltf/primitive.h"
#include "lambert/formats/gltf/skin.h"

#include <utility>

namespace lambert::gltf {

std::vector<PlacedSurface> Meshes::of_node(std::size_t node) {
  const JsonView json = document_->root()["nodes"][node];
  if (!json["mesh"]) return {};
  const JsonView mesh = document_->referred("meshes", json["mesh"]), skin = json["skin"];
  const auto& own_weights = hierarchy_->pose(node).weights;
  const std::vector<float> weights = own_weights ? *own_weights : mesh["weights"].numbers();
  if (skin) return read(mesh, weights, document_->referred("skins", skin));

  const std::pair key(json["mesh"].count(), weights);
  const auto known = unskinned_.find(key);
  return known != unskinned_.end() ? known->second : unskinned_.emplace(key, read(mesh, weights, skin)).first->second;
}

std::vector<PlacedSurface> Meshes::read(const JsonView& mesh, const std::vector<float>& weights, const JsonView& skin) {
  const std::vector<Mat4> joints = skin ? joint_matrices(skin) : std::vector<Mat4>{};
  std::vector<PlacedSurface> surfaces;
  for_each(mesh["primitives"], [&](const JsonView& json) {
    std::optional<Primitive> primitive = read_primitive(*document_, json, weights);
    if (!primitive || primitive->mesh.triangles.empty()) return;
    PlacedSurface placed;
    placed.in_world = skin && !primitive->joint_sets.empty();
    if (placed.in_world) apply_skin(*primitive, joints, json);
    repair_directions(primitive->mesh, document_->notes);
    primitive->mesh.name = mesh["name"].text("");
    const SurfaceMaterial material = materials_.get(variants_.material_of(json));
    placed.surface.material = material.id;
    placed.surface.emission = material.emission;
    placed.surface.geometry = graph_->add_geometry(std::move(primitive->mesh));
    surfaces.push_back(placed);
  });
  return surfaces;
}

/// glTF 2.0, 3.7.3.1: the joint's world transform times its inverse bind matrix.
std::vector<Mat4> Meshes::joint_matrices(const JsonView& skin) {
  std::vector<Mat4> matrices;
  for_each(skin["joints"], [&](const JsonView& reference) {
    document_->referred("nodes", reference);
    matrices.push_back(hierarchy_->world(reference.count()));
  });
  const JsonView reference = skin["inverseBindMatrices"];
  if (!reference) return matrices;
  const Accessor accessor = document_->accessor(reference);
  if (accessor.components() != 16) accessor.fail("expected MAT4 inverse bind matrices");
  if (accessor.count() < matrices.size())
    accessor.fail("has " + std::to_string(accessor.count()) + " matrices for " + std::to_string(matrices.size()) +
                  " joints");
  const std::vector<float> m = accessor.floats();
  for (std::size_t joint = 0; joint < matrices.size(); ++joint) {
    Mat4 inverse_bind;
    for (std::size_t i = 0; i < 16; ++i)
      inverse_bind[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = m[16 * joint + i];
    matrices[joint] *= inverse_bind;
  }
  return matrices;
}

}  // namespace lambert::gltf
