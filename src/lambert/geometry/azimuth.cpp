#include "lambert/geometry/azimuth.h"

namespace lambert {

Bounds3 sector_bounds(float inner, float outer, float phi_max, float z_min, float z_max) {
  Bounds3 box;
  box.add({inner, 0, z_min});
  box.add({outer, 0, z_max});
  const float c = std::cos(phi_max), s = std::sin(phi_max);
  box.add({inner * c, inner * s, z_min});
  box.add({outer * c, outer * s, z_max});
  // The cosine of a rounded angle may be off by an ulp of 1.
  const float slack = 1e-6f * outer;
  box.min -= Vec3(slack, slack, 0), box.max += Vec3(slack, slack, 0);
  if (phi_max >= 0.5f * pi) box.max.y = outer;
  if (phi_max >= pi) box.min.x = -outer;
  if (phi_max >= 1.5f * pi) box.min.y = -outer;
  box.max.x = outer;
  return box;
}

}  // namespace lambert
