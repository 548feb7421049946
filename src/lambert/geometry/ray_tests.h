#pragma once
/// Ray intersections in their textbook forms, in double: what they say is what the renderer's shapes must say.

#include "lambert/base/vec.h"

#include <optional>
#include <span>
#include <variant>

namespace lambert {

/// Where the line p1 + t (p2 - p1) meets a plane.
struct NoMeeting {};
struct LiesInPlane {};
using PlaneMeeting = std::variant<double, NoMeeting, LiesInPlane>;

/// The plane a x + b y + c z + d = 0: t is the plane's value at p1 over its change from p1 to p2 (row PG-62).
PlaneMeeting line_plane(Vec3d p1, Vec3d p2, double a, double b, double c, double d);
/// The plane through s with normal n: t = n.(s - p1) / n.(p2 - p1) (row PG-63).
PlaneMeeting line_plane(Vec3d p1, Vec3d p2, Vec3d s, Vec3d n);
/// For a ray t >= 0, for a segment 0 <= t <= 1.
bool on_ray(double t);
bool on_segment(double t);

/// The area of a triangle by its three projections (row PG-66): half the root of the sum of their squared determinants.
double triangle_area(Vec3d a, Vec3d b, Vec3d c);
/// The areas opposite a, b and c over the whole, for p in the triangle's plane (row PG-65). They add up to 1 inside and
/// to more outside, since areas have no sign.
Vec3d barycentric_by_areas(Vec3d p, Vec3d a, Vec3d b, Vec3d c);
bool inside_by_areas(Vec3d p, Vec3d a, Vec3d b, Vec3d c, double tolerance = 1e-9);
/// The plane's meeting if it lies ahead and inside the triangle (row PG-64).
std::optional<double> ray_triangle(Vec3d origin, Vec3d direction, Vec3d a, Vec3d b, Vec3d c);

/// Whether `p` lies in a planar polygon, judged without the coordinate `drop_axis` (row PG-67): crossings of a
/// half-line, an edge owning its lower end.
bool inside_projected_polygon(Vec3d p, std::span<const Vec3> polygon, int drop_axis);

}  // namespace lambert
