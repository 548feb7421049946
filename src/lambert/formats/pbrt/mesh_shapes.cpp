#include "lambert/formats/pbrt/mesh_shapes.h"

#include "lambert/formats/input_file.h"
#include "lambert/formats/readers.h"

#include <algorithm>
#include <utility>

namespace lambert::pbrt {
namespace {

std::uint32_t checked_index(const ParameterList& list, int index, std::size_t vertex_count) {
  if (index < 0 || static_cast<std::size_t>(index) >= vertex_count) {
    list.fail("index " + std::to_string(index) + " is out of range: there are " + std::to_string(vertex_count) +
              " points");
  }
  return static_cast<std::uint32_t>(index);
}

/// "indices" in groups of `corners`; those of the one face that stands for itself when there are none.
std::vector<std::uint32_t> indices(const ParameterList& list, std::size_t corners, std::size_t vertex_count) {
  const std::vector<int> given = list.integers("indices");
  std::vector<std::uint32_t> result;
  if (given.empty()) {
    if (vertex_count != corners) list.fail("has no \"integer indices\"");
    for (std::uint32_t i = 0; i < corners; ++i) result.push_back(i);
    return result;
  }
  if (given.size() % corners != 0) {
    list.fail("the number of indices must be a multiple of " + std::to_string(corners) + ", found " +
              std::to_string(given.size()));
  }
  result.reserve(given.size());
  for (const int i : given) result.push_back(checked_index(list, i, vertex_count));
  return result;
}

void check_length(const ParameterList& list, const char* name, std::size_t length, std::size_t vertex_count) {
  if (length == 0 || length == vertex_count) return;
  list.fail(std::string("'") + name + "' has " + std::to_string(length) + " values for " +
            std::to_string(vertex_count) + " points");
}

/// The attributes that meshes of triangles and patches share.
TriangleMesh vertices(const ParameterList& list) {
  TriangleMesh mesh;
  mesh.positions = list.vectors3("P", ParameterType::point3);
  if (mesh.positions.empty()) list.fail("has no \"point3 P\"");
  mesh.normals = list.vectors3("N", ParameterType::normal);
  mesh.uvs = list.vectors2("uv", ParameterType::point2);
  check_length(list, "N", mesh.normals.size(), mesh.positions.size());
  check_length(list, "uv", mesh.uvs.size(), mesh.positions.size());
  return mesh;
}

void set_triangles(const ParameterList& list, TriangleMesh& mesh) {
  const std::vector<std::uint32_t> corners = indices(list, 3, mesh.positions.size());
  mesh.triangles.resize(corners.size() / 3);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    mesh.triangles[i] = {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
  }
}

bool is_planar(const std::vector<Vec3>& p, const std::uint32_t* corner) {
  const Vec3 a = p[corner[1]] - p[corner[0]], b = p[corner[2]] - p[corner[0]], c = p[corner[3]] - p[corner[0]];
  const float size = length(a) + length(b) + length(c);
  return std::abs(dot(cross(a, b), c)) <= 1e-5f * size * size * size;
}

}  // namespace

void orient_by_normals(TriangleMesh& mesh) {
  if (mesh.normals.empty()) return;
  for (Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const Vec3 sum = mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]];
    if (dot(cross(b - a, c - a), sum) < 0) std::swap(t[1], t[2]);
  }
}

TriangleMesh triangle_mesh(const ParameterList& list) {
  TriangleMesh mesh = vertices(list);
  const std::vector<Vec3> tangents = list.vectors3("S", ParameterType::vector3);
  check_length(list, "S", tangents.size(), mesh.positions.size());
  for (const Vec3 t : tangents) mesh.tangents.emplace_back(t, 1.0f);
  set_triangles(list, mesh);
  orient_by_normals(mesh);
  return mesh;
}

TriangleMesh bilinear_mesh(const Context& context, const ParameterList& list) {
  TriangleMesh mesh = vertices(list);
  const std::vector<std::uint32_t> corners = indices(list, 4, mesh.positions.size());
  bool planar = true;
  for (std::size_t i = 0; i < corners.size(); i += 4) {
    // Corners come as p00, p10, p01, p11; outward is the side from which u to v turns counter-clockwise.
    const std::uint32_t* p = &corners[i];
    mesh.triangles.push_back({p[0], p[1], p[3]});
    mesh.triangles.push_back({p[0], p[3], p[2]});
    planar = planar && is_planar(mesh.positions, p);
  }
  if (!planar) context.notes.add("shape 'bilinearmesh': patches that are not planar become two triangles");
  orient_by_normals(mesh);
  return mesh;
}

TriangleMesh loop_subdivision_cage(const Context& context, const ParameterList& list) {
  context.notes.add("shape 'loopsubdiv': its control mesh is shown, not its limit surface");
  TriangleMesh mesh;
  mesh.positions = list.vectors3("P", ParameterType::point3);
  if (mesh.positions.empty()) list.fail("has no \"point3 P\"");
  list.integer("levels", 3);
  list.string("scheme", "loop");
  set_triangles(list, mesh);
  compute_smooth_normals(mesh);
  return mesh;
}

GeometryId add_ply_mesh(Context& context, const ParameterList& list) {
  const std::string filename = list.string("filename", "");
  if (filename.empty()) list.fail("has no \"string filename\"");
  const std::string path = context.resolve(filename).string();
  if (const auto known = context.ply_meshes.find(path); known != context.ply_meshes.end()) return known->second;
  return at_directive(list, [&] {
    const InputFile file(path);
    TriangleMesh mesh = read_ply(file.bytes(), path, context.notes);
    orient_by_normals(mesh);
    const GeometryId id = context.graph.add_geometry(std::move(mesh));
    context.ply_meshes.emplace(path, id);
    return id;
  });
}

}  // namespace lambert::pbrt
