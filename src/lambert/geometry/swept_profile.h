#pragma once
/// What extrusion and revolution share: a chain of straight segments that is moved, and the mesh it leaves behind.

#include "lambert/base/angle.h"
#include "lambert/geometry/mesh.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace lambert {

/// A segment of the chain with the outward unit normals of its surface at both ends; zero where it leaves none, which
/// drops the segment.
struct ProfileSegment {
  std::size_t from, to;  ///< points
  double length;
  Vec3d from_normal, to_normal;
};

/// Vertices of the mesh that move together.
struct ProfileRow {
  std::size_t point;
  Vec3d normal;
  double along;  ///< of the chain's length, in [0, 1]
};

struct SweptProfile {
  std::vector<ProfileRow> rows;
  std::vector<std::pair<std::size_t, std::size_t>> strips;  ///< rows of the two ends of a segment
};

/// Rows for the segments of one chain, in order. Where normals turn by less than `crease` from one segment to the next
/// they are averaged, at a closed chain's seam as well.
SweptProfile swept_profile(std::span<const ProfileSegment> segments, bool closed, Angle crease);

struct SweptVertex {
  Vec3 position, normal;
  Vec2 uv;
};

/// Appends the triangle unless two of its corners are in one place.
void add_triangle(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// Appends the strips between rows and the columns 0 to `steps`; at(row, column) gives the vertices. Facing
/// ∂p/∂column × ∂p/∂row.
template <class At>
void add_strips(TriangleMesh& mesh, const SweptProfile& profile, std::uint32_t steps, const At& at) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const ProfileRow& row : profile.rows)
    for (std::uint32_t column = 0; column <= steps; ++column) {
      const SweptVertex v = at(row, column);
      mesh.positions.push_back(v.position), mesh.normals.push_back(v.normal), mesh.uvs.push_back(v.uv);
    }
  for (const auto& [from, to] : profile.strips)
    for (std::uint32_t column = 0; column < steps; ++column) {
      const std::uint32_t a = first + static_cast<std::uint32_t>(from) * (steps + 1) + column;
      const std::uint32_t c = first + static_cast<std::uint32_t>(to) * (steps + 1) + column;
      add_triangle(mesh, a, a + 1, c + 1);
      add_triangle(mesh, a, c + 1, c);
    }
}

/// Appends a flat cap: triangles of `corners`, whose positions and uvs are given; turned over when `reverse`.
void add_cap(TriangleMesh& mesh, std::span<const Vec3> positions, std::span<const Vec2> uvs,
             std::span<const Triangle> triangles, Vec3 normal, bool reverse);

/// What a modeller counts: corners that lie in one place once, quads and the triangles at poles, caps whole.
struct SolidCounts {
  std::size_t vertices = 0, quads = 0, triangles = 0, caps = 0;
  bool operator==(const SolidCounts&) const = default;
};

}  // namespace lambert
