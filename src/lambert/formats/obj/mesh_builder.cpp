#include "lambert/formats/obj/mesh_builder.h"

#include "lambert/base/hash.h"

#include <utility>

namespace lambert::obj {

std::size_t MeshBuilder::CornerHash::operator()(const Corner& c) const {
  return static_cast<std::size_t>(mix_bits((std::uint64_t{c.position} << 32 | c.uv) ^ mix_bits(c.normal)));
}

std::uint32_t MeshBuilder::vertex(const Corner& c, const VertexData& data) {
  const auto [entry, is_new] = vertices_.try_emplace(c, static_cast<std::uint32_t>(mesh_.positions.size()));
  if (!is_new) return entry->second;
  mesh_.positions.push_back(data.positions[c.position]);
  if (!data.colours.empty()) mesh_.colours.push_back(data.colours[c.position]);
  // v runs down the image here, up in the file.
  mesh_.uvs.push_back(c.uv == no_index ? Vec2(0) : Vec2(data.uvs[c.uv].x, 1 - data.uvs[c.uv].y));
  has_uvs_ = has_uvs_ || c.uv != no_index;
  if (c.normal != no_index) mesh_.normals.push_back(data.normals[c.normal]);
  has_normals_ = has_normals_ || c.normal != no_index;
  return entry->second;
}

void MeshBuilder::add_face(std::span<const Corner> corners, const VertexData& data) {
  face_.clear();
  for (const Corner& c : corners) face_.push_back(vertex(c, data));
  if (face_.size() == 3) {
    mesh_.triangles.push_back({face_[0], face_[1], face_[2]});
  } else {
    triangulate_face(mesh_.positions, face_, mesh_.triangles);
  }
}

TriangleMesh MeshBuilder::finish(bool smooth) {
  if (!has_uvs_) mesh_.uvs.clear();
  // Colours may begin in the middle of a file.
  if (mesh_.colours.size() != mesh_.positions.size()) mesh_.colours.clear();
  if (smooth && !has_normals_) compute_smooth_normals(mesh_);
  vertices_.clear();
  return std::move(mesh_);
}

}  // namespace lambert::obj
