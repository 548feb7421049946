#pragma once
#include "lambert/base/vec.h"

namespace lambert {

/// A rectangle as seen from a point, sampled uniformly by solid angle (Ureña, Fajardo and King, "An Area-Preserving
/// Parametrization for Spherical Rectangles", 2013).
class SphericalRectangle {
 public:
  /// `edge_u` and `edge_v` must be perpendicular. Good for solid angles above about 1e-5 sr; smaller ones lose digits.
  SphericalRectangle(Vec3 from, Vec3 corner, Vec3 edge_u, Vec3 edge_v);
  float solid_angle() const { return solid_angle_; }
  /// The place on the rectangle in [0,1]² along its edges. The density is 1 / solid_angle() per steradian at `from`.
  Vec2 sample(Vec2 u) const;
  /// The inverse of sample().
  Vec2 to_square(Vec2 place) const;

 private:
  float x0_, y0_, x1_, y1_, z0_;  // in the frame of the rectangle, seen from the origin, z0 < 0
  float b0_, b1_, k_;
  float solid_angle_;
};

}  // namespace lambert
