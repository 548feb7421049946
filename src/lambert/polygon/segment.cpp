#include "lambert/polygon/segment.h"

#include "lambert/polygon/accurate.h"
#include "lambert/polygon/scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lambert::polygon {
namespace {

std::pair<Vec2d, Vec2d> ascending(const Segment& s) {
  return compare_xy(s.a, s.b) <= 0 ? std::pair(s.a, s.b) : std::pair(s.b, s.a);
}

/// The parameter of p, which lies on s.
double parameter_on(const Segment& s, Vec2d p) {
  if (p == s.a) return 0;
  if (p == s.b) return 1;
  const Vec2d d = s.b - s.a;
  const double t = std::abs(d.x) > std::abs(d.y) ? (p.x - s.a.x) / d.x : (p.y - s.a.y) / d.y;
  return std::clamp(t, 0.0, 1.0);
}

/// Both lie on one line.
SegmentMeeting meet_on_line(const Segment& v, const Segment& w) {
  const auto [v_low, v_high] = ascending(v);
  const auto [w_low, w_high] = ascending(w);
  const Vec2d from = compare_xy(v_low, w_low) >= 0 ? v_low : w_low;
  const Vec2d to = compare_xy(v_high, w_high) <= 0 ? v_high : w_high;
  const int order = compare_xy(from, to);
  if (order > 0) return {.kind = SegmentCase::collinear_disjoint};
  const bool same = v_low == w_low && v_high == w_high;
  const SegmentCase kind = same        ? SegmentCase::superimposed
                           : order < 0 ? SegmentCase::collinear_overlap
                                       : SegmentCase::collinear_touching;
  return {kind, parameter_on(v, from), parameter_on(w, from), from, to};
}

SegmentMeeting meet_parallel(const Segment& v, const Segment& w) {
  // Where one is a point, only the other has a line to ask.
  const bool one_line = orientation(v.a, v.b, w.a) == 0 && orientation(w.a, w.b, v.a) == 0;
  return one_line ? meet_on_line(v, w) : SegmentMeeting{.kind = SegmentCase::parallel_disjoint};
}

/// In the boxes of both.
Vec2d crossing_point(const Segment& v, const Segment& w, double t) {
  return glm::clamp(point_between(v.a, v.b, t), glm::min(w.a, w.b), glm::max(w.a, w.b));
}

}  // namespace

SegmentMeeting intersect(const Segment& v, const Segment& w) {
  const auto lines = meet_lines(v, w);
  if (!lines) return meet_parallel(v, w);
  const int wa = orientation(v.a, v.b, w.a), wb = orientation(v.a, v.b, w.b);
  const int va = orientation(w.a, w.b, v.a), vb = orientation(w.a, w.b, v.b);
  if (wa * wb > 0 || va * vb > 0) return {SegmentCase::lines_cross_outside, lines->t, lines->p};
  SegmentMeeting meeting{SegmentCase::crossing, std::clamp(lines->t, 0.0, 1.0), std::clamp(lines->p, 0.0, 1.0)};
  if (va == 0) meeting.t = 0;
  if (vb == 0) meeting.t = 1;
  if (wa == 0) meeting.p = 0;
  if (wb == 0) meeting.p = 1;
  meeting.from = va == 0 ? v.a : vb == 0 ? v.b : wa == 0 ? w.a : wb == 0 ? w.b : crossing_point(v, w, meeting.t);
  meeting.to = meeting.from;
  return meeting;
}

std::optional<LineMeeting> meet_lines(const Segment& v, const Segment& w) {
  // With the names of the notes: AD - CB = -(v x w), ED - FB = -((W1 - V1) x w), AF - CE = v x (W1 - V1) ...
  if (turn_sign(v.a, v.b, w.a, w.b) == 0) return std::nullopt;
  const CrossProduct determinant{v.a, v.b, w.a, w.b};
  return LineMeeting{accurate_quotient({v.a, w.a, w.a, w.b}, determinant),
                     accurate_quotient({v.a, w.a, v.a, v.b}, determinant)};
}

std::string_view name_of(SegmentCase c) {
  constexpr std::array<std::string_view, 7> names{"lines_cross_outside", "crossing",           "parallel_disjoint",
                                                  "collinear_disjoint",  "collinear_touching", "collinear_overlap",
                                                  "superimposed"};
  return names[static_cast<std::size_t>(c)];
}

bool intersect_half_open(const Segment& v, const Segment& w) {
  const int wa = orientation(v.a, v.b, w.a), wb = orientation(v.a, v.b, w.b);
  const int va = orientation(w.a, w.b, v.a), vb = orientation(w.a, w.b, v.b);
  // A closed hit of lines that are not parallel, and neither end b on the other line.
  return vb != 0 && wb != 0 && wa * wb <= 0 && va * vb <= 0;
}

double signed_coordinate(Vec2d a, Vec2d b, Vec2d p) {
  const double scale = unit_scale(sizes_of(std::array{a, b, p}).most);
  const Vec2d along = scale * b - scale * a;
  return dot(scale * p - scale * a, along) / safe_length(along) / scale;
}

}  // namespace lambert::polygon
