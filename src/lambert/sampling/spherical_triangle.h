#pragma once
#include "lambert/base/vec.h"

#include <array>

namespace lambert {

/// A triangle as seen from a point, sampled uniformly by solid angle (Arvo, "Stratified Sampling of Spherical
/// Triangles", 1995).
class SphericalTriangle {
 public:
  /// The solid angle is 0 when `from` lies in the triangle's plane.
  SphericalTriangle(Vec3 from, const std::array<Vec3, 3>& vertices);
  float solid_angle() const { return solid_angle_; }
  /// A unit direction; its density is 1 / solid_angle() per steradian.
  Vec3 sample(Vec2 u) const;
  /// The inverse of sample() for a unit direction inside.
  Vec2 to_square(Vec3 w) const;

 private:
  Vec3 a_, b_, c_, e_;      // unit: the vertices, and across a towards c
  float one_plus_ab_, eb_;  // 1 + a.b, e.b
  float volume_;            // |a.(b x e)|
  float solid_angle_ = 0;
};

}  // namespace lambert
