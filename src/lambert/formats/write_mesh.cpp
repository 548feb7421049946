#include "lambert/formats/write_mesh.h"

#include "lambert/base/error.h"
#include "lambert/base/file.h"
#include "lambert/base/standard_streams.h"

namespace lambert {

std::vector<std::string> mesh_extensions() { return {".ply", ".obj", ".glb"}; }

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh) {
  validate(mesh);
  const std::string extension = format_extension(path);
  if (extension == ".ply") return write_atomically(path, ply_of(mesh));
  if (extension == ".obj") return write_atomically(path, obj_of(mesh));
  if (extension == ".glb") return write_atomically(path, glb_of(mesh));
  throw Error(path.string() + ": unknown extension " + unknown_word(extension, mesh_extensions()));
}

}  // namespace lambert
