#pragma once
#include "lambert/image/probe/map_point.h"

#include <array>
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

  std::optional<Vec3> direction(MapPoint at) const {
    const CubeFace& face = cube_faces[static_cast<std::size_t>(at.chart)];
    if (opengl) mirror(at);
    return normalize(face.ahead + (2 * at.uv.x - 1) * face.right + (1 - 2 * at.uv.y) * face.up);
  }
  std::optional<MapPoint> point(Vec3 d) const {
    const float x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    const int chart = 2 * axis + (d[axis] < 0 ? 1 : 0);
    const CubeFace& face = cube_faces[static_cast<std::size_t>(chart)];
    const float scale = 0.5f / std::abs(d[axis]);
    MapPoint at{chart, {0.5f + scale * dot(d, face.right), 0.5f - scale * dot(d, face.up)}};
    if (opengl) mirror(at);
    return at;
  }
  float density(MapPoint at) const {
    const float s = 1 + sqr(2 * at.uv.x - 1) + sqr(1 - 2 * at.uv.y);
    return 4 / (s * std::sqrt(s));
  }

 private:
  static void mirror(MapPoint& at) {
    float& across = at.chart / 2 == 1 ? at.uv.y : at.uv.x;
    across = 1 - across;
  }
};

}  // namespace lambert::probe
