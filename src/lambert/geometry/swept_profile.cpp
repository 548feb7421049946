#include "lambert/geometry/swept_profile.h"

#include <cmath>

namespace lambert {
namespace {

bool leaves_surface(const ProfileSegment& segment) { return segment.from_normal != Vec3d(0); }

}  // namespace

SweptProfile swept_profile(std::span<const ProfileSegment> segments, bool closed, Angle crease) {
  const double least_cosine = std::cos(static_cast<double>(crease.radians()));
  double total = 0;
  for (const ProfileSegment& segment : segments) total += segment.length;

  SweptProfile profile;
  double along = 0;
  const auto row = [&](std::size_t point, Vec3d normal) {
    profile.rows.push_back({point, normal, total > 0 ? along / total : 0});
    return profile.rows.size() - 1;
  };
  // Whether the strip of a segment continues that of another without an edge.
  const auto continues = [&](const ProfileSegment& a, const ProfileSegment& b) {
    return leaves_surface(a) && leaves_surface(b) && a.to == b.from && dot(a.to_normal, b.from_normal) > least_cosine;
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const ProfileSegment& segment = segments[i];
    if (!leaves_surface(segment)) {
      along += segment.length;
      continue;
    }
    std::size_t from;
    if (i > 0 && continues(segments[i - 1], segment)) {
      from = profile.strips.back().second;
      profile.rows[from].normal = normalize(segments[i - 1].to_normal + segment.from_normal);
    } else {
      from = row(segment.from, segment.from_normal);
    }
    along += segment.length;
    profile.strips.emplace_back(from, row(segment.to, segment.to_normal));
  }
  if (closed && segments.size() > 1 && continues(segments.back(), segments.front())) {
    const Vec3d normal = normalize(segments.back().to_normal + segments.front().from_normal);
    profile.rows[profile.strips.front().first].normal = profile.rows[profile.strips.back().second].normal = normal;
  }
  return profile;
}

void add_triangle(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::vector<Vec3>& p = mesh.positions;
  if (p[a] != p[b] && p[b] != p[c] && p[c] != p[a]) mesh.triangles.push_back({a, b, c});
}

void add_cap(TriangleMesh& mesh, std::span<const Vec3> positions, std::span<const Vec2> uvs,
             std::span<const Triangle> triangles, Vec3 normal, bool reverse) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), positions.begin(), positions.end());
  mesh.normals.insert(mesh.normals.end(), positions.size(), normal);
  for (const Vec2 uv : uvs) mesh.uvs.push_back(reverse ? Vec2(1 - uv.x, uv.y) : uv);
  for (const Triangle& t : triangles)
    add_triangle(mesh, first + t[0], first + t[reverse ? 2 : 1], first + t[reverse ? 1 : 2]);
}

}  // namespace lambert
