#pragma once
#include "lambert/image/probe/map_point.h"

#include <array>
#include <cmath>
#include <optional>

namespace lambert::probe {

/// What a face looks along, and what is to its right and up.
struct CubeFace {
  const char* name;
  Vec3 ahead, right, up;
};

/// Six views of 90 degrees from the centre, as a camera would take them: px and nx to the sides, py with what is behind
/// (+z) at its top, ny with what is ahead (-z) at its top, pz behind, nz ahead. OpenEXR's faces are turned alike.
inline constexpr std::array<CubeFace, 6> cube_faces{{
    {"px", {1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {"nx", {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    {"py", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {"ny", {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {"pz", {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}},
    {"nz", {0, 0, -1}, {1, 0, 0}, {0, 1, 0}},
}};

/// The largest coordinate of a direction names the face, the other two divided by it are the place on it:
///   d ∝ ahead + a right + b up,  a = 2u - 1,  b = 1 - 2v,  dω = 4 (1 + a² + b²)^-3/2 du dv
/// Where two coordinates are equal, x goes before y before z.
struct Cube {
  static constexpr int charts = 6;
  /// The faces as OpenGL, Direct3D, KTX and glTF's image-based lights have them: seen from outside, so that px, nx, pz
  /// and nz are mirrored left to right, py and ny top to bottom.
  bool opengl = false;
  bool operator==(const Cube&) const = default;

  std::optional<Vec3> direction(MapPoint at) const {
    const CubeFace& face = cube_faces[static_cast<std::size_t>(at.chart)];
    const float a = mirror_across(at.chart) * (2 * at.uv.x - 1), b = mirror_up(at.chart) * (1 - 2 * at.uv.y);
    return (face.ahead + a * face.right + b * face.up) * (1 / std::sqrt(1 + a * a + b * b));
  }
  std::optional<MapPoint> point(Vec3 d) const {
    // Without branches or tables: loops over this run eight directions at a time. Across and up are the dot products
    // with the face's `right` and `up`.
    const float x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    const bool on_x = x >= y && x >= z, on_y = !on_x && y >= z;
    const float ahead = on_x ? d.x : on_y ? d.y : d.z, sign = std::copysign(1.0f, ahead);
    const float turned_x = -sign * d.x, turned_z = sign * d.z;
    const float across = on_x ? turned_z : on_y ? d.x : turned_x, up = on_y ? turned_z : d.y;
    const float scale = 0.5f / std::abs(ahead);
    const int axis = on_x ? 0 : on_y ? 2 : 4, chart = axis + (ahead < 0 ? 1 : 0);
    return MapPoint{chart, {0.5f + mirror_across(chart) * scale * across, 0.5f - mirror_up(chart) * scale * up}};
  }
  float density(MapPoint at) const {
    const float s = 1 + sqr(2 * at.uv.x - 1) + sqr(1 - 2 * at.uv.y);
    return 4 / (s * std::sqrt(s));
  }

 private:
  float mirror_across(int chart) const { return 1 - 2 * static_cast<float>(opengl & (chart / 2 != 1)); }
  float mirror_up(int chart) const { return 1 - 2 * static_cast<float>(opengl & (chart / 2 == 1)); }
};

}  // namespace lambert::probe
