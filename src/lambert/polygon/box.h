#pragma once
#include "lambert/polygon/ring.h"

#include <glm/common.hpp>

#include <limits>
#include <span>

namespace lambert::polygon {

/// An axis-aligned box with its boundary; empty (min > max) until something is added (PG-46).
struct Box2 {
  Vec2d min{std::numeric_limits<double>::infinity()};
  Vec2d max{-std::numeric_limits<double>::infinity()};

  bool empty() const { return min.x > max.x || min.y > max.y; }
  void add(Vec2d p) { min = glm::min(min, p), max = glm::max(max, p); }
  void add(const Box2& b) { min = glm::min(min, b.min), max = glm::max(max, b.max); }
  Vec2d size() const { return empty() ? Vec2d(0) : max - min; }
  Vec2d centre() const { return 0.5 * min + 0.5 * max; }
  bool contains(Vec2d p) const { return p.x >= min.x && p.y >= min.y && p.x <= max.x && p.y <= max.y; }
  /// Whether they share a point, be it of their boundaries.
  bool overlaps(const Box2& b) const {
    return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y;
  }
  bool operator==(const Box2&) const = default;
};

inline Box2 box_of(std::span<const Vec2d> points) {
  Box2 box;
  for (const Vec2d p : points) box.add(p);
  return box;
}

inline Box2 box_of(const Rings& rings) {
  Box2 box;
  for (const Ring& ring : rings) box.add(box_of(ring));
  return box;
}

}  // namespace lambert::polygon
