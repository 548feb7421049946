#pragma once
/// How the sphere of directions is laid out flat. World: right-handed, +y up. All but the octahedral maps look along -z
/// with +x to the right and are seen from within the sphere, as a photograph is; docs/guide/probe.md has the table.
/// Coordinates (u, v) run over [0,1]² of a chart, u to the right, v down.

#include "lambert/image/probe/cube.h"
#include "lambert/image/probe/fisheye.h"
#include "lambert/image/probe/lat_long.h"
#include "lambert/image/probe/map_point.h"
#include "lambert/image/probe/mirror_ball.h"
#include "lambert/image/probe/octahedral.h"

#include <concepts>
#include <optional>
#include <variant>

namespace lambert::probe {

/// `direction` gives a unit vector, none where the chart shows nothing (outside the disk of a ball); `point` inverts
/// it, none for directions that are not shown. `density` is dω / (du dv), 0 where nothing is shown. Lat-long, cube and
/// octahedral maps go on smoothly, or folded, at least a texel beyond [0,1]².
template <class P>
concept Projection = requires(const P& p, MapPoint at, Vec3 d) {
  { P::charts } -> std::convertible_to<int>;
  { p.direction(at) } -> std::same_as<std::optional<Vec3>>;
  { p.point(d) } -> std::same_as<std::optional<MapPoint>>;
  { p.density(at) } -> std::same_as<float>;
};

template <Projection... P>
using OneOf = std::variant<P...>;
using AnyProjection = OneOf<LatLong, MirrorBall, Fisheye, Cube, Octahedral, EqualArea>;

inline std::optional<Vec3> direction(const AnyProjection& projection, MapPoint at) {
  return std::visit([&](const auto& p) { return p.direction(at); }, projection);
}
inline std::optional<MapPoint> point(const AnyProjection& projection, Vec3 d) {
  return std::visit([&](const auto& p) { return p.point(d); }, projection);
}
inline float density(const AnyProjection& projection, MapPoint at) {
  return std::visit([&](const auto& p) { return p.density(at); }, projection);
}
inline int chart_count(const AnyProjection& projection) {
  return std::visit([](const auto& p) { return p.charts; }, projection);
}

}  // namespace lambert::probe
