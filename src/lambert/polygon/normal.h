#pragma once
/// Polygons in space: their normals, whether they are planar, and how to lay them into the plane.

#include "lambert/polygon/ring.h"

#include <glm/common.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace lambert::polygon {

/// The unit normal of the plane A x + B y + C z + D = 0 (PG-16); none when A = B = C = 0. Rounded.
std::optional<Vec3d> plane_normal(double a, double b, double c);

/// The unit normal of the first three vertices that do not lie on one line, by the cross product of their edges
/// (PG-17); none when all lie on one, which is decided exactly. It points to where these three turn left: at a reflex
/// corner that is away from newell_normal(). O(n).
std::optional<Vec3d> three_vertex_normal(std::span<const Vec3d> vertices);

/// Twice the area vector of a closed face of n corners (PG-18): the sum over its edges of coordinate differences times
/// sums (Newell), taken relative to corner 0 so that faces far from the origin lose no digits. It points to where the
/// face runs counter-clockwise; zero when all corners lie on a line, or when areas of opposite sense cancel. Products
/// of coordinates must be doubles; newell_normal() and face_area() take any. `corner(i)` is a Vec3d.
template <class CornerOf>
Vec3d newell_sum(std::size_t n, CornerOf corner) {
  Vec3d sum(0);
  if (n == 0) return sum;
  const Vec3d origin = corner(0);
  Vec3d a = corner(n - 1) - origin;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3d b = corner(i) - origin;
    sum += Vec3d((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    a = b;
  }
  return sum;
}

inline Vec3d newell_sum(std::span<const Vec3d> vertices) {
  return newell_sum(vertices.size(), [vertices](std::size_t i) { return vertices[i]; });
}

/// newell_sum at unit length; none when it is zero. Rounded. Of any finite coordinates.
std::optional<Vec3d> newell_normal(std::span<const Vec3d> vertices);

/// Half the length of newell_sum: the area of a planar face whose edges do not cross. Infinite or 0 only where the area
/// itself is too large or too small for a double.
double face_area(std::span<const Vec3d> vertices);

/// Whether all vertices lie on one line, decided exactly.
bool on_one_line(std::span<const Vec3d> vertices);

/// The largest |e . n| over the unit edge vectors e, n being the Newell normal (PG-19, E-PG-09): the sine of the
/// largest angle between an edge and the plane, so that its tolerance is an angle in radians and no length. Edges
/// without length are passed over; 1 when there is no normal. O(n).
double out_of_plane_sine(std::span<const Vec3d> vertices);

inline bool is_planar(std::span<const Vec3d> vertices, double epsilon = 1e-4) {
  return out_of_plane_sine(vertices) < epsilon;
}

/// 0, 1 or 2: the axis along which |n| is largest. Dropped, it leaves a plane's points the other two coordinates.
inline int dominant_axis(Vec3d n) {
  const Vec3d size = glm::abs(n);
  return size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
}

/// Drops the dominant axis of `normal`, exactly; the other two stand in the order in which what runs counter-clockwise
/// about the normal stays so. Areas shrink by the factor |normal[axis]| / |normal|.
class PlaneProjection {
 public:
  explicit PlaneProjection(Vec3d normal);
  int axis() const { return axis_; }
  Vec2d operator()(Vec3d p) const { return {p[first_], p[second_]}; }
  Ring operator()(std::span<const Vec3d> vertices) const;

 private:
  int axis_, first_, second_;
};

}  // namespace lambert::polygon
