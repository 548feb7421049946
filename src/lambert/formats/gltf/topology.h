#pragma once
#include "lambert/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambert::gltf {

enum class Topology { triangles = 4, triangle_strip = 5, triangle_fan = 6 };

/// The triangles that `indices` mean, counter-clockwise ones facing outward. Indices left over at the end are dropped.
std::vector<Triangle> triangles_of(Topology topology, std::span<const std::uint32_t> indices);

}  // namespace lambert::gltf
