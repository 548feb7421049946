#include "lambert/formats/gltf/primitive.h"

#include "lambert/base/number.h"
#include "lambert/formats/gltf/topology.h"
#include "lambert/formats/gltf/vertices.h"

#include <algorithm>
#include <utility>

namespace lambert::gltf {
namespace {

/// Skins and colours have sets with numbers; these are the ones that are read.
void note_unread_attributes(const JsonView& attributes, Notes& notes) {
  static constexpr std::string_view read[] = {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0", "TEXCOORD_1", "COLOR_0"};
  for (const std::string& name : attributes.keys()) {
    const bool joint = name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
    if (joint || std::find(std::begin(read), std::end(read), name) != std::end(read)) continue;
    notes.add("glTF vertex attribute " + printable(name) + " is ignored");
  }
}

std::vector<Vec4> read_colours(const Vertices& vertices) {
  if (!vertices.has("COLOR_0")) return {};
  if (vertices.components("COLOR_0") == 4) return vertices.vectors<Vec4>("COLOR_0");
  std::vector<Vec4> colours;
  for (const Vec3 c : vertices.vectors<Vec3>("COLOR_0")) colours.emplace_back(c, 1.0f);
  return colours;
}

std::vector<JointSet> read_joint_sets(const Vertices& vertices) {
  std::vector<JointSet> sets;
  for (std::size_t n = 0;; ++n) {
    const std::string joints = "JOINTS_" + std::to_string(n), weights = "WEIGHTS_" + std::to_string(n);
    if (!vertices.has(joints) || !vertices.has(weights)) return sets;
    sets.push_back({vertices.vectors<Vec4>(joints), vertices.vectors<Vec4>(weights)});
  }
}

template <class Vec>
void add_scaled(std::vector<Vec>& to, const std::vector<Vec3>& displacements, float weight) {
  for (std::size_t i = 0; i < std::min(to.size(), displacements.size()); ++i)
    for (int c = 0; c < 3; ++c) to[i][c] += weight * displacements[i][c];
}

void apply_morph_targets(const JsonView& targets, const Vertices& vertices, std::span<const float> weights,
                         TriangleMesh& mesh) {
  for (std::size_t i = 0, n = std::min(targets.size(), weights.size()); i < n; ++i) {
    if (weights[i] == 0) continue;
    add_scaled(mesh.positions, vertices.vectors<Vec3>(targets[i]["POSITION"]), weights[i]);
    add_scaled(mesh.normals, vertices.vectors<Vec3>(targets[i]["NORMAL"]), weights[i]);
    add_scaled(mesh.tangents, vertices.vectors<Vec3>(targets[i]["TANGENT"]), weights[i]);
  }
}

std::optional<Topology> topology_of(const JsonView& mode, Notes& notes) {
  const std::size_t number = mode.count(4);
  if (number > 6) mode.fail("unknown mode " + std::to_string(number) + " (known: 0 to 6)");
  if (number >= 4) return static_cast<Topology>(number);
  notes.add(number == 0 ? "glTF points are ignored" : "glTF lines are ignored");
  return std::nullopt;
}

}  // namespace

std::optional<Primitive> read_primitive(Document& document, const JsonView& json, std::span<const float> weights) {
  const std::optional<Topology> topology = topology_of(json["mode"], document.notes);
  if (!topology) return std::nullopt;
  const JsonView attributes = json["attributes"];
  if (!attributes["POSITION"]) {
    document.notes.add("glTF primitives without positions are ignored");
    return std::nullopt;
  }
  note_unread_attributes(attributes, document.notes);
  const Vertices vertices(document, json);
  Primitive primitive;
  TriangleMesh& mesh = primitive.mesh;
  // Draco data are triangle lists, whatever the mode was before.
  const bool draco = json.extension("KHR_draco_mesh_compression").exists();
  mesh.triangles = triangles_of(draco ? Topology::triangles : *topology, vertices.indices());
  mesh.positions = vertices.vectors<Vec3>("POSITION");
  mesh.normals = vertices.vectors<Vec3>("NORMAL");
  mesh.tangents = vertices.vectors<Vec4>("TANGENT");
  mesh.uvs = vertices.vectors<Vec2>("TEXCOORD_0");
  mesh.uvs1 = vertices.vectors<Vec2>("TEXCOORD_1");
  mesh.colours = read_colours(vertices);
  primitive.joint_sets = read_joint_sets(vertices);
  apply_morph_targets(json["targets"], vertices, weights, mesh);
  return primitive;
}

void repair_directions(TriangleMesh& mesh, Notes& notes) {
  if (mesh.normals.empty()) mesh.tangents.clear();
  for (Vec4& tangent : mesh.tangents) tangent.w = tangent.w < 0 ? -1.0f : 1.0f;
  std::vector<Vec3> from_shape;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const float l = length(mesh.normals[i]);
    if (l > 0) {
      mesh.normals[i] /= l;
      continue;
    }
    if (from_shape.empty()) {
      TriangleMesh copy = mesh;
      compute_smooth_normals(copy);
      from_shape = std::move(copy.normals);
      notes.add("glTF normals of length zero are replaced by the shape's");
    }
    mesh.normals[i] = from_shape[i];
  }
}

}  // namespace lambert::gltf
