#pragma once
#include "lambert/base/vec.h"

#include <glm/common.hpp>

#include <cstdint>
#include <span>

namespace lambert {

/// Twice the area vector of a closed face: the sum over its edges of coordinate differences times sums (Newell). Points
/// to where the face runs counter-clockwise; zero when all corners lie on a line.
inline Vec3d newell_normal(std::span<const Vec3> positions, std::span<const std::uint32_t> face) {
  Vec3d n(0);
  const Vec3d origin(positions[face[0]]);
  Vec3d a = Vec3d(positions[face.back()]) - origin;
  for (const std::uint32_t corner : face) {
    const Vec3d b = Vec3d(positions[corner]) - origin;
    n += Vec3d((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    a = b;
  }
  return n;
}

/// 0, 1 or 2: the axis along which |n| is largest. Dropped, it leaves a plane's points the other two coordinates.
inline int dominant_axis(Vec3d n) {
  const Vec3d size = glm::abs(n);
  return size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
}

}  // namespace lambert
