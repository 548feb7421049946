#include "lambert/formats/little_endian.h"
#include "lambert/formats/write_mesh.h"

namespace lambert {

std::string ply_of(const TriangleMesh& mesh) {
  const bool normals = !mesh.normals.empty(), uvs = !mesh.uvs.empty();
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.positions.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\n";
  if (normals) out += "property float nx\nproperty float ny\nproperty float nz\n";
  if (uvs) out += "property float s\nproperty float t\n";
  out += "element face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar uint vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    append_bytes(out, mesh.positions[i]);
    if (normals) append_bytes(out, mesh.normals[i]);
    if (uvs) append_bytes(out, mesh.uvs[i]);
  }
  for (const Triangle& t : mesh.triangles) {
    out += '\3';
    append_bytes(out, t);
  }
  return out;
}

}  // namespace lambert
