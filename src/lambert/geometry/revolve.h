#pragma once
#include "lambert/base/angle.h"
#include "lambert/geometry/mesh.h"
#include "lambert/geometry/swept_profile.h"
#include "lambert/polygon/ring.h"

#include <span>

namespace lambert {

struct Revolution {
  Vec3d origin{0}, axis{0, 1, 0};  ///< the line of rotation; the axis need not be a unit vector
  Vec3d reference{1, 0, 0};        ///< made perpendicular to the axis: where a region's +x points at angle 0
  Angle start{};
  Angle sweep = degrees(360);  ///< counter-clockwise seen against the axis, above 0, at most one revolution
  int steps = 32;              ///< at least 3 for a full revolution, else 1
  Angle crease = degrees(30);  ///< strips that turn by less look smooth
};

/// The surface that a chain of points leaves when it turns about a line: a strip of quads for each segment, triangles
/// where one end lies on the line, nothing where both do. It faces right of the chain, where the chain is drawn with
/// the line's direction upward and the distance from the line to the right. uv: around and along the chain. A point
/// nearer to the line than the rounding of its distance lies on it. Throws Error when there are fewer than 2 points,
/// something is not finite, or the axis, the sweep or the steps are out of range, or there would be more than 2^24
/// vertices. O(points times steps).
TriangleMesh revolve(std::span<const Vec3d> profile, const Revolution& revolution = {});

/// The solid that a region leaves whose x is the distance from the line and y the height along it; less than a full
/// revolution gets caps at both ends. Closed (is_closed()) when rings do not cross and holes lie inside; they may
/// touch. Throws as above, and when an x is negative or the region has no area.
TriangleMesh revolve(const polygon::Region& region, const Revolution& revolution = {});

SolidCounts revolution_counts(std::span<const Vec3d> profile, const Revolution& revolution = {});
SolidCounts revolution_counts(const polygon::Region& region, const Revolution& revolution = {});

}  // namespace lambert
