#include "mesh_output.h"
#include "../print_path.h"

#include "lambert/base/standard_streams.h"
#include "lambert/formats/write_mesh.h"

#include <algorithm>

namespace lambert::cli {

bool write_meshes(PolygonOptions& o, const std::function<TriangleMesh()>& mesh) {
  const std::vector<std::string> known = mesh_extensions();
  const auto names_no_mesh = [&](const std::string& path) {
    return std::ranges::find(known, format_extension(path)) == known.end();
  };
  const auto meshes = std::stable_partition(o.outputs.begin(), o.outputs.end(), names_no_mesh);
  const std::vector<std::string> paths(meshes, o.outputs.end());
  o.outputs.erase(meshes, o.outputs.end());
  if (paths.empty()) return false;
  const TriangleMesh made = mesh();
  for (const std::string& path : paths) {
    write_mesh(path, made);
    print_path(path);
  }
  o.mesh_written = true;
  return o.outputs.empty() && o.svg.empty() && o.png.empty();
}

}  // namespace lambert::cli
