#pragma once
#include "lambert/image/probe/fast_atan2.h"
#include "lambert/image/probe/map_point.h"

#include <optional>

namespace lambert::probe {

/// Latitude and longitude (equirectangular): v = θ / π from +y down; the centre looks along -z, columns go from there
/// towards +x, as the renderer's environment light and panoramic camera have it.
///   d = (sin θ sin φ, cos θ, -sin θ cos φ),  φ = 2π (u - 1/2),  dω = 2π² sin θ du dv
struct LatLong {
  static constexpr int charts = 1;
  bool centre_is_plus_z = false;  ///< turned half around, as OpenEXR's envmap attribute defines it

  bool operator==(const LatLong&) const = default;

  std::optional<Vec3> direction(MapPoint at) const {
    const float theta = pi * at.uv.y, phi = 2 * pi * (at.uv.x - 0.5f), ring = turn() * std::sin(theta);
    return Vec3(ring * std::sin(phi), std::cos(theta), -ring * std::cos(phi));
  }
  std::optional<MapPoint> point(Vec3 d) const {
    const float phi = fast_atan2(turn() * d.x, -turn() * d.z);
    const float theta = fast_atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y);
    return MapPoint{0, {0.5f + phi * (0.5f * inv_pi), theta * inv_pi}};
  }
  float density(MapPoint at) const { return 2 * pi * pi * std::abs(std::sin(pi * at.uv.y)); }

 private:
  float turn() const { return centre_is_plus_z ? -1.0f : 1.0f; }
};

}  // namespace lambert::probe
