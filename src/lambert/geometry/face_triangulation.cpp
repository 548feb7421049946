#include "lambert/geometry/mesh.h"
#include "lambert/polygon/decompose/ear_clipping.h"
#include "lambert/polygon/queries/convex.h"
#include "lambert/polygon/queries/normal.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

/// Along the diagonal from corner 0, or the other one where that leaves the face.
void split_quad(std::span<const Vec3> positions, std::span<const std::uint32_t> face, std::vector<Triangle>& out) {
  const Vec3 a = positions[face[0]], ab = positions[face[1]] - a, ac = positions[face[2]] - a,
             ad = positions[face[3]] - a;
  const Vec3 normal = cross(ac, ad - ab);
  const bool first_diagonal = dot(cross(ab, ac), normal) > 0 && dot(cross(ac, ad), normal) > 0;
  const std::size_t i = first_diagonal ? 0 : 1;
  out.push_back({face[i], face[i + 1], face[i + 2]});
  out.push_back({face[i], face[i + 2], face[(i + 3) % 4]});
}

/// The face's corners without the normal's largest coordinate, counter-clockwise.
std::vector<Vec2d> project(std::span<const Vec3> positions, std::span<const std::uint32_t> face, Vec3d normal) {
  const polygon::PlaneProjection flatten(normal);
  const Vec3d origin(positions[face[0]]);
  std::vector<Vec2d> flat;
  flat.reserve(face.size());
  for (const std::uint32_t v : face) flat.push_back(flatten(Vec3d(positions[v]) - origin));
  return flat;
}

}  // namespace

void triangulate_face(std::span<const Vec3> positions, std::span<const std::uint32_t> face,
                      std::vector<Triangle>& out) {
  if (face.size() < 3) return;
  const auto fan = [&] {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) out.push_back({face[0], face[i], face[i + 1]});
  };
  const auto exists = [&](std::uint32_t v) { return v < positions.size(); };
  if (face.size() == 3 || !std::all_of(face.begin(), face.end(), exists)) return fan();
  if (face.size() == 4) return split_quad(positions, face, out);

  const Vec3d normal = polygon::newell_sum(face.size(), [&](std::size_t i) { return Vec3d(positions[face[i]]); });
  const double squared = glm::dot(normal, normal);
  if (!(squared > 0) || !std::isfinite(squared)) return fan();
  const std::vector<Vec2d> flat = project(positions, face, normal);
  if (polygon::is_convex(flat)) return fan();
  for (const Triangle& t : polygon::clip_ears(flat)) out.push_back({face[t[0]], face[t[1]], face[t[2]]});
}

}  // namespace lambert
