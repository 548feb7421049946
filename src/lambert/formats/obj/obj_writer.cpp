#include "lambert/base/number.h"
#include "lambert/formats/write_mesh.h"

#include <initializer_list>

namespace lambert {

std::string obj_of(const TriangleMesh& mesh) {
  std::string out;
  const auto line = [&](const char* word, std::initializer_list<float> numbers) {
    out += word;
    for (const float n : numbers) {
      out += " ";
      append_number(out, n);
    }
    out += "\n";
  };
  for (const Vec3 p : mesh.positions) line("v", {p.x, p.y, p.z});
  for (const Vec2 uv : mesh.uvs) line("vt", {uv.x, 1 - uv.y});
  for (const Vec3 n : mesh.normals) line("vn", {n.x, n.y, n.z});
  for (const Triangle& t : mesh.triangles) {
    out += "f";
    for (const std::uint32_t corner : t) {
      const std::string index = std::to_string(corner + 1);
      out += " " + index;
      if (mesh.uvs.empty() && mesh.normals.empty()) continue;
      out += "/" + (mesh.uvs.empty() ? "" : index);
      if (!mesh.normals.empty()) out += "/" + index;
    }
    out += "\n";
  }
  return out;
}

}  // namespace lambert
