#pragma once
#include "lambert/base/vec.h"

#include <cmath>

namespace lambert {

/// A right-handed orthonormal frame (s, t, n); local +z is n.
struct Frame {
  Vec3 s{1, 0, 0}, t{0, 1, 0}, n{0, 0, 1};

  Frame() = default;
  /// Any frame about the unit vector `normal` (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017).
  explicit Frame(Vec3 normal) : n(normal) {
    const float sign = std::copysign(1.0f, n.z), a = -1.0f / (sign + n.z), b = n.x * n.y * a;
    s = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
    t = {b, sign + n.y * n.y * a, -n.y};
  }
  /// The frame about unit `normal` whose s lies along `tangent` as nearly as possible; any frame if they are parallel.
  static Frame from_tangent(Vec3 normal, Vec3 tangent) {
    const Vec3 projected = tangent - dot(tangent, normal) * normal;
    const float squared = dot(projected, projected);
    if (!(squared > 1e-6f * dot(tangent, tangent))) return Frame(normal);
    Frame f;
    f.n = normal, f.s = projected * (1 / std::sqrt(squared));
    f.s -= dot(f.s, normal) * normal;  // again: what is left of a nearly parallel tangent is mostly rounding
    f.t = cross(normal, f.s);
    return f;
  }
  Vec3 to_local(Vec3 v) const { return {dot(v, s), dot(v, t), dot(v, n)}; }
  Vec3 to_world(Vec3 v) const { return v.x * s + v.y * t + v.z * n; }
};

}  // namespace lambert
