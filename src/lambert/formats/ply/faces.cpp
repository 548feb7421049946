#include "lambert/formats/ply/faces.h"

#include <utility>

namespace lambert::ply {

void FaceList::add_polygon(std::span<const std::uint32_t> face) {
  if (face.size() < 3) return;
  if (face.size() == 3) {
    triangles_.push_back({face[0], face[1], face[2]});
    return;
  }
  corners_.insert(corners_.end(), face.begin(), face.end());
  sizes_.push_back(face.size());
}

void FaceList::add_strip(std::span<const std::uint32_t> strip) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    if (strip[i] == no_corner) start = i + 1;
    if (i < start + 2) continue;
    const bool odd = (i - start) % 2 == 1;
    triangles_.push_back({strip[odd ? i - 1 : i - 2], strip[odd ? i - 2 : i - 1], strip[i]});
  }
}

void FaceList::finish(TriangleMesh& mesh) {
  mesh.triangles = std::move(triangles_);
  std::size_t first = 0;
  for (const std::size_t size : sizes_) {
    triangulate_face(mesh.positions, std::span(corners_).subspan(first, size), mesh.triangles);
    first += size;
  }
}

}  // namespace lambert::ply
