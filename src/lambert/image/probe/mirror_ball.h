#pragma once
#include "lambert/image/probe/disk.h"
#include "lambert/image/probe/map_point.h"

#include <cmath>
#include <limits>
#include <optional>

namespace lambert::probe {

/// A photograph of a mirror ball that touches all four sides of the square. The camera looks along -z with +x to the
/// right: the centre shows +z, where the camera stands, the rim what is behind the ball.
///
/// From afar the surface normal at (x, y) is n = (x, y, √(1 - x² - y²)), and d = 2 (n·z) n - z; since d is at twice the
/// angle of n, dω = 4 dA everywhere. From a distance of D radii a ray at the angle β to the axis meets the ball where
/// sin γ = D sin β is the sine of its angle to the normal, and leaves it at θ = 2γ - β from +z.
struct MirrorBall {
  static constexpr int charts = 1;
  /// Of the camera from the ball's centre, in radii, above 1; the ball lies on the camera's axis. A cone of half angle
  /// asin(1 / distance) behind the ball is then not seen.
  float distance = std::numeric_limits<float>::infinity();
  static constexpr int axis = 1;  ///< the centre shows +z

  float angle(float radius) const;  ///< θ from the axis, at a radius of [0, 1] on the disk
  float radius(float angle) const;  ///< above 1 for what is not seen

  bool operator==(const MirrorBall&) const = default;

  std::optional<Vec3> direction(MapPoint at) const {
    const Vec2 p = disk_point(at.uv);
    const float r2 = dot(p, p);
    if (r2 > 1) return std::nullopt;
    if (!std::isinf(distance)) return from_near(p);
    const float n_z = std::sqrt(1 - r2);
    return Vec3(2 * n_z * p, 2 * n_z * n_z - 1);
  }
  std::optional<MapPoint> point(Vec3 d) const;
  float density(MapPoint at) const;

 private:
  Vec3 from_near(Vec2 on_disk) const;
};

}  // namespace lambert::probe
