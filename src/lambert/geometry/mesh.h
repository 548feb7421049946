#pragma once
#include "lambert/base/bounds.h"
#include "lambert/base/transform.h"
#include "lambert/base/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lambert {

using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh. Counter-clockwise triangles face outward. Per-vertex arrays are empty or as long as
/// `positions`.
struct TriangleMesh {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Vec3> normals;
  std::vector<Vec4> tangents;  ///< xyz along +u, w = ±1: bitangent = w cross(normal, tangent) (as in glTF)
  std::vector<Vec2> uvs;
  std::vector<Vec2> uvs1;     ///< second set
  std::vector<Vec4> colours;  ///< linear RGBA, multiplied into the base colour

  Bounds3 bounds() const;
  float area() const;  ///< one side
  /// Enclosed by a closed mesh (is_closed()): positive when its triangles face outward.
  float volume() const;
};

/// Throws Error naming mesh, array and index when an index is out of range, an array has the wrong length or a number
/// is not finite.
void validate(const TriangleMesh& mesh);
/// Whether it bounds a solid: each edge, known by the positions of its ends, runs as often one way as the other, and no
/// triangle has two corners in one place. O(n log n).
bool is_closed(const TriangleMesh& mesh);
/// The mesh mapped by `t`; triangles are turned round when it mirrors.
TriangleMesh transformed(TriangleMesh mesh, const Transform& t);
/// Normals per vertex, weighted by angle; for meshes that have none and want to be smooth.
void compute_smooth_normals(TriangleMesh& mesh);
/// Appends the face.size() - 2 triangles of a planar or nearly planar polygon of indices into `positions`: a fan when
/// convex, ears otherwise. A face without area, or with a number that is not finite or an index out of range, becomes a
/// fan; validate() refuses the latter two.
void triangulate_face(std::span<const Vec3> positions, std::span<const std::uint32_t> face, std::vector<Triangle>& out);

}  // namespace lambert
