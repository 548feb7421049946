#pragma once
/// Meshes as files: positions, triangles, and normals and texture coordinates where the mesh has them. Other attributes
/// are not written.

#include "lambert/geometry/mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lambert {

/// Binary PLY 1.0, little endian; texture coordinates are s and t.
std::string ply_of(const TriangleMesh& mesh);
/// OBJ text; v of its texture coordinates runs up, unlike that of meshes.
std::string obj_of(const TriangleMesh& mesh);
/// A glTF 2.0 container with the mesh in one node of one scene, white and rough.
std::string glb_of(const TriangleMesh& mesh);

/// Writes by extension (.ply .obj .glb), whole or not at all. Throws Error naming the path, or when the mesh does
/// not pass validate().
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh);
std::vector<std::string> mesh_extensions();

}  // namespace lambert
