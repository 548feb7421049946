#include "lambert/geometry/revolve.h"

#include "lambert/base/error.h"
#include "lambert/geometry/flat_region.h"
#include "lambert/geometry/unit_circle.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

bool finite(Vec3d v) { return is_finite(Vec3(v)); }

void check(const Revolution& r) {
  if (!finite(r.origin) || !finite(r.axis) || !finite(r.reference) || !(length(r.axis) > 0))
    throw Error("revolve: expected a finite axis other than 0");
  if (!(r.sweep > Angle() && r.sweep <= degrees(360)) || !std::isfinite(r.start.radians()))
    throw Error("revolve: expected an angle above 0 and of 360 degrees at most");
  if (const int least = r.sweep == degrees(360) ? 3 : 1; r.steps < least)
    throw Error("revolve: expected at least " + std::to_string(least) + " steps" +
                (least > 1 ? " for a full turn" : "") + ", got " + std::to_string(r.steps));
}

/// Before anything is made: a mesh has this many corners for each point of the chain.
void check_size(std::size_t points, const Revolution& r) {
  constexpr std::size_t most = std::size_t{1} << 22;
  const auto steps = static_cast<std::size_t>(r.steps);
  if (steps > most / std::max<std::size_t>(points, 1))
    throw Error("revolve: " + std::to_string(points) + " points times " + std::to_string(steps) +
                " steps are more than 4194304 vertices; take fewer steps");
}

/// A point as its height above the origin and its way from the line at angle 0; a quarter further on, the way is
/// `side`.
struct Spoke {
  Vec3d foot, out, side;
  bool on_axis() const { return out == Vec3d(0); }
};

class Turn {
 public:
  explicit Turn(const Revolution& r)
      : revolution_(r),
        axis_(normalize(r.axis)),
        full_(r.sweep == degrees(360)),
        steps_(static_cast<std::uint32_t>(r.steps)) {
    const double start = turns(r.start), sweep = full_ ? 1 : turns(r.sweep);
    for (std::uint32_t i = 0; i <= steps_; ++i) angles_.push_back(unit_circle(start + sweep * i / steps_));
    if (full_) angles_.back() = angles_.front();
    // The reference, or the unit vector farthest from the axis where it is parallel.
    reference_ = r.reference - dot(r.reference, axis_) * axis_;
    if (!(length(reference_) > 1e-6 * length(r.reference))) {
      Vec3d unit(0);
      const Vec3d size = glm::abs(axis_);
      unit[size.x <= size.y && size.x <= size.z ? 0 : (size.y <= size.z ? 1 : 2)] = 1;
      reference_ = unit - dot(unit, axis_) * axis_;
    }
    reference_ = normalize(reference_);
  }

  bool is_full() const { return full_; }
  std::uint32_t steps() const { return steps_; }

  Spoke spoke(Vec3d p) const {
    const Vec3d from_origin = p - revolution_.origin, foot = dot(from_origin, axis_) * axis_;
    const Vec3d out = from_origin - foot;
    // A difference, a dot product and a difference are rounded.
    const double rounding = 0x1p-50 * (length(p) + length(revolution_.origin));
    return made(revolution_.origin + foot, length(out) <= rounding ? Vec3d(0) : out);
  }
  Spoke spoke(Vec2d p) const { return made(revolution_.origin + p.y * axis_, p.x * reference_); }

  Vec3 position(const Spoke& s, std::uint32_t column) const {
    return Vec3(s.foot + angles_[column].x * s.out + angles_[column].y * s.side);
  }
  /// A direction given at angle 0.
  Vec3 direction(Vec3d d, std::uint32_t column) const {
    const Vec3d along = dot(d, axis_) * axis_, out = d - along;
    return Vec3(along + angles_[column].x * out + angles_[column].y * cross(axis_, out));
  }

  /// The segments of a chain through the spokes `first` to `first` + count - 1.
  std::vector<ProfileSegment> segments(std::span<const Spoke> spokes, std::size_t first, std::size_t count,
                                       bool closed) const {
    std::vector<ProfileSegment> all;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
      const std::size_t a = first + i, b = first + (i + 1) % count;
      const Spoke &from = spokes[a], &to = spokes[b];
      const Vec3d step = to.foot + to.out - from.foot - from.out;
      if (!(length(step) > 0)) continue;
      // At a pole the surface has the direction of the strip's other end.
      const auto normal = [&](const Spoke& here, const Spoke& other) {
        const Vec3d n = cross(here.on_axis() ? other.side : here.side, step);
        return length(n) > 0 ? normalize(n) : Vec3d(0);
      };
      Vec3d from_normal = normal(from, to), to_normal = normal(to, from);
      if (from_normal == Vec3d(0)) from_normal = to_normal;
      if (to_normal == Vec3d(0)) to_normal = from_normal;
      all.push_back({a, b, length(step), from_normal, to_normal});
    }
    return all;
  }

  void add(TriangleMesh& mesh, std::span<const Spoke> spokes, std::span<const ProfileSegment> segments,
           bool closed) const {
    add_strips(mesh, swept_profile(segments, closed, revolution_.crease), steps_,
               [&](const ProfileRow& row, std::uint32_t column) {
                 return SweptVertex{
                     position(spokes[row.point], column), direction(row.normal, column),
                     Vec2(static_cast<float>(column) / static_cast<float>(steps_), static_cast<float>(row.along))};
               });
  }

  void add_caps(TriangleMesh& mesh, std::span<const Spoke> spokes, const FlatRegion& flat) const {
    if (full_) return;
    const Vec3d back = cross(reference_, axis_);
    for (const bool end : {false, true}) {
      const std::uint32_t column = end ? steps_ : 0;
      std::vector<Vec3> positions;
      for (const Spoke& s : spokes) positions.push_back(position(s, column));
      add_cap(mesh, positions, flat.uvs, flat.triangles, direction(end ? -back : back, column), end);
    }
  }

 private:
  /// The quotient of floats gives quarters exactly.
  static double turns(Angle a) { return static_cast<double>(a.radians() / degrees(360).radians()); }
  Spoke made(Vec3d foot, Vec3d out) const { return {foot, out, cross(axis_, out)}; }

  const Revolution& revolution_;
  Vec3d axis_, reference_;
  bool full_;
  std::uint32_t steps_;
  std::vector<Vec2d> angles_;
};

std::vector<Spoke> spokes_of(std::span<const Vec3d> profile, const Turn& turn) {
  if (profile.size() < 2) throw Error("revolve: expected a profile of 2 points at least");
  std::vector<Spoke> spokes;
  for (const Vec3d p : profile) {
    if (!finite(p))
      throw Error("revolve: point " + std::to_string(spokes.size()) +
                  " of the profile is beyond 3.4e38, the range of float, in which meshes are kept");
    spokes.push_back(turn.spoke(p));
  }
  return spokes;
}

std::vector<Spoke> spokes_of(const FlatRegion& flat, const Turn& turn) {
  std::vector<Spoke> spokes;
  for (const Vec2d p : flat.vertices) {
    if (p.x < 0) throw Error("revolve: the region lies on both sides of the axis (a negative x)");
    spokes.push_back(turn.spoke(p));
  }
  return spokes;
}

SolidCounts count(std::span<const Spoke> spokes, std::span<const ProfileSegment> segments, const Turn& turn) {
  SolidCounts counts;
  const std::size_t columns = turn.steps() + (turn.is_full() ? 0 : 1);
  for (const Spoke& s : spokes) counts.vertices += s.on_axis() ? 1 : columns;
  for (const ProfileSegment& segment : segments) {
    const int poles = spokes[segment.from].on_axis() + spokes[segment.to].on_axis();
    (poles == 0 ? counts.quads : counts.triangles) += poles < 2 ? turn.steps() : 0;
  }
  return counts;
}

}  // namespace

TriangleMesh revolve(std::span<const Vec3d> profile, const Revolution& revolution) {
  check(revolution);
  check_size(profile.size(), revolution);
  const Turn turn(revolution);
  const std::vector<Spoke> spokes = spokes_of(profile, turn);
  TriangleMesh mesh;
  turn.add(mesh, spokes, turn.segments(spokes, 0, spokes.size(), false), false);
  return mesh;
}

TriangleMesh revolve(const polygon::Region& region, const Revolution& revolution) {
  check(revolution);
  const FlatRegion flat = flat_region(region, "revolve");
  check_size(flat.vertices.size(), revolution);
  const Turn turn(revolution);
  const std::vector<Spoke> spokes = spokes_of(flat, turn);
  TriangleMesh mesh;
  std::size_t first = 0;
  for (const polygon::Ring& ring : flat.rings) {
    turn.add(mesh, spokes, turn.segments(spokes, first, ring.size(), true), true);
    first += ring.size();
  }
  turn.add_caps(mesh, spokes, flat);
  return mesh;
}

SolidCounts revolution_counts(std::span<const Vec3d> profile, const Revolution& revolution) {
  check(revolution);
  const Turn turn(revolution);
  const std::vector<Spoke> spokes = spokes_of(profile, turn);
  return count(spokes, turn.segments(spokes, 0, spokes.size(), false), turn);
}

SolidCounts revolution_counts(const polygon::Region& region, const Revolution& revolution) {
  check(revolution);
  const Turn turn(revolution);
  const FlatRegion flat = flat_region(region, "revolve");
  const std::vector<Spoke> spokes = spokes_of(flat, turn);
  SolidCounts counts;
  std::vector<ProfileSegment> segments;
  std::size_t first = 0;
  for (const polygon::Ring& ring : flat.rings) {
    const auto more = turn.segments(spokes, first, ring.size(), true);
    segments.insert(segments.end(), more.begin(), more.end());
    first += ring.size();
  }
  counts = count(spokes, segments, turn);
  counts.caps = turn.is_full() ? 0 : 2;
  return counts;
}

}  // namespace lambert
