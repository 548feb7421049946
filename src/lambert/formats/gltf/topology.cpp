#include "lambert/formats/gltf/topology.h"

namespace lambert::gltf {

std::vector<Triangle> triangles_of(Topology topology, std::span<const std::uint32_t> indices) {
  std::vector<Triangle> triangles;
  const std::size_t n = indices.size();
  if (topology == Topology::triangles) {
    triangles.reserve(n / 3);
    for (std::size_t i = 0; i + 3 <= n; i += 3) triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    return triangles;
  }
  for (std::size_t i = 0; i + 3 <= n; ++i) {
    if (topology == Topology::triangle_fan) {
      triangles.push_back({indices[i + 1], indices[i + 2], indices[0]});
    } else {
      // Every other triangle of a strip is turned round.
      triangles.push_back({indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
    }
  }
  return triangles;
}

}  // namespace lambert::gltf
