#pragma once
#include "lambert/base/vec.h"

#include <optional>

namespace lambert {

/// A sphere seen from a point outside: the cone of directions that it fills.
class SphereCone {
 public:
  /// None from inside and from so near the surface that the cone is a hemisphere within rounding.
  static std::optional<SphereCone> from(Vec3 point, Vec3 centre, float radius);

  /// Outward unit normal of the point of the sphere that is seen in a direction drawn uniformly from the cone.
  Vec3 sample_normal(Vec2 u) const;
  float pdf_omega() const;  ///< 1 / solid angle [1/sr]

 private:
  SphereCone(Vec3 axis, float sin_squared_max) : axis_(axis), sin_squared_max_(sin_squared_max) {}
  float one_minus_cos_max() const;
  Vec3 axis_;  // from the centre to the point
  float sin_squared_max_;
};

}  // namespace lambert
