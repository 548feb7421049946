#pragma once
#include "lambert/base/vec.h"

#include <glm/common.hpp>

#include <limits>

namespace lambert {

/// An axis-aligned box; empty (min > max) until something is added.
struct Bounds3 {
  Vec3 min{std::numeric_limits<float>::infinity()};
  Vec3 max{-std::numeric_limits<float>::infinity()};

  bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
  void add(Vec3 p) { min = glm::min(min, p), max = glm::max(max, p); }
  void add(const Bounds3& b) { min = glm::min(min, b.min), max = glm::max(max, b.max); }
  Vec3 centre() const { return 0.5f * (min + max); }
  Vec3 diagonal() const { return max - min; }
  /// Radius of the sphere about centre() through the corners; 0 when empty.
  float radius() const { return empty() ? 0 : 0.5f * length(diagonal()); }
  bool contains(Vec3 p) const {
    return p.x >= min.x && p.y >= min.y && p.z >= min.z && p.x <= max.x && p.y <= max.y && p.z <= max.z;
  }
  Vec3 corner(int i) const { return {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z}; }
  bool operator==(const Bounds3&) const = default;
};

}  // namespace lambert
