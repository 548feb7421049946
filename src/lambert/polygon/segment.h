#pragma once
#include "lambert/polygon/lerp.h"
#include "lambert/polygon/predicates.h"
#include "lambert/polygon/scale.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace lambert::polygon {

/// From a to b; a point when they coincide.
struct Segment {
  Vec2d a, b;
  /// a at t = 0 and b at t = 1, exactly.
  Vec2d at(double t) const { return lerp(a, b, t); }
  bool operator==(const Segment&) const = default;
};

/// Where the lines of two segments meet: at v.at(t) = w.at(p).
struct LineMeeting {
  double t, p;
};

/// The 2x2 system of PG-10 by Cramer's rule; none when the lines are parallel, which is decided exactly. t and p are
/// within 2^-46 of their size.
std::optional<LineMeeting> meet_lines(const Segment& v, const Segment& w);

/// What two segments have in common. All but the first two are cases of a determinant that is 0 (PG-12); a segment that
/// is a point counts as parallel to every other.
enum class SegmentCase : std::uint8_t {
  lines_cross_outside,  ///< not parallel, nothing in common
  crossing,             ///< not parallel, one point in common, which may be an end
  parallel_disjoint,    ///< on two parallel lines
  collinear_disjoint,   ///< on one line with a gap between them
  collinear_touching,   ///< on one line with one point in common
  collinear_overlap,    ///< on one line with a segment in common
  superimposed,         ///< the same segment, or in reverse
};

std::string_view name_of(SegmentCase c);

struct SegmentMeeting {
  SegmentCase kind = SegmentCase::parallel_disjoint;
  /// Of `crossing`: the point's parameters, in [0, 1]. Of collinear_touching, collinear_overlap and superimposed: those
  /// of `from` on both segments. Of lines_cross_outside: where the lines cross.
  double t = 0, p = 0;
  /// What they have in common: from `from` to `to`, lexicographically ascending; a point when they are equal. An end of
  /// either is given as it is; a crossing of both interiors is rounded: within 2^-45 of the length of v and a unit in
  /// the last place, and inside the boxes of both.
  Vec2d from{0}, to{0};

  bool meet() const {
    return kind == SegmentCase::crossing || kind == SegmentCase::collinear_touching ||
           kind == SegmentCase::collinear_overlap || kind == SegmentCase::superimposed;
  }
  bool operator==(const SegmentMeeting&) const = default;
};

/// Ends included. The case is decided exactly, of any finite coordinates.
SegmentMeeting intersect(const Segment& v, const Segment& w);

/// Whether v without its end b meets w without its end b in one point (t and p in [0, 1), PG-11): edges of a chain that
/// join end to start do not meet then. Depends on the segments' directions: for walks along polygons only. Parallel
/// segments never meet so. Exact.
bool intersect_half_open(const Segment& v, const Segment& w);

/// The place of p along the line from a to b as a signed length from a: positive towards b (E-PG-06). a and b differ.
double signed_coordinate(Vec2d a, Vec2d b, Vec2d p);

/// Whether the directions of v and w are orthogonal (PG-13); a point is orthogonal to all. Exact.
inline bool orthogonal(const Segment& v, const Segment& w) { return dot_sign(v.a, v.b, w.a, w.b) == 0; }

/// The foot of the perpendicular from p to the line through a and b (PG-42).
template <class Point>
struct Foot {
  double t;  ///< on the segment ab while in [0, 1]
  Point point;
  double distance;  ///< from p to the foot
  bool on_segment() const { return t >= 0 && t <= 1; }
};

/// In the plane or in space, of any size; none when a = b. Rounded.
template <class Point>
std::optional<Foot<Point>> foot_of_perpendicular(const Point& a, const Point& b, const Point& p) {
  if (a == b) return std::nullopt;
  const double near = unit_scale(largest_component(a - b)), far = unit_scale(largest_component(a - p));
  const Point along = near * (a - b), to_a = far * (a - p);
  const double t = dot(to_a, along) / dot(along, along) * (near / far);
  const Point foot = lerp(a, b, t);
  return Foot<Point>{t, foot, safe_length(p - foot)};
}

/// From p to the nearest point of the segment ab, which may be a point. Rounded.
template <class Point>
double distance_to_segment(const Point& a, const Point& b, const Point& p) {
  const auto foot = foot_of_perpendicular(a, b, p);
  if (foot && foot->on_segment()) return foot->distance;
  return std::fmin(safe_length(p - a), safe_length(p - b));
}

}  // namespace lambert::polygon
