#include "lambert/geometry/mesh.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

double cross2(Vec2d a, Vec2d b) { return a.x * b.y - a.y * b.x; }

/// The face's vertices in the plane across its Newell normal, counter-clockwise.
std::vector<Vec2d> project(std::span<const Vec3> positions, std::span<const std::uint32_t> face) {
  Vec3d n(0);
  const Vec3d origin(positions[face[0]]);
  for (std::size_t i = 0; i < face.size(); ++i)
    n += glm::cross(Vec3d(positions[face[i]]) - origin, Vec3d(positions[face[(i + 1) % face.size()]]) - origin);
  const Vec3d size = glm::abs(n);
  const int drop = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int a = (drop + 1) % 3, b = (drop + 2) % 3;
  std::vector<Vec2d> flat;
  for (const std::uint32_t v : face) {
    const Vec3d p = Vec3d(positions[v]) - origin;
    flat.emplace_back(n[drop] < 0 ? p[b] : p[a], n[drop] < 0 ? p[a] : p[b]);
  }
  return flat;
}

bool is_convex(const std::vector<Vec2d>& p) {
  const std::size_t n = p.size();
  double turning = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d u = p[(i + 1) % n] - p[i], v = p[(i + 2) % n] - p[(i + 1) % n];
    const double turn = cross2(u, v);
    if (turn < 0) return false;
    turning += std::atan2(turn, glm::dot(u, v));
  }
  return turning < 7;  // one revolution, not two (a pentagram turns one way as well)
}

bool inside(Vec2d p, Vec2d a, Vec2d b, Vec2d c) {
  return cross2(b - a, p - a) >= 0 && cross2(c - b, p - b) >= 0 && cross2(a - c, p - c) >= 0;
}

/// Ear clipping; when no ear is left (a self-intersecting face) the flattest corner is cut, so that it always ends.
void clip_ears(const std::vector<Vec2d>& p, std::span<const std::uint32_t> face, std::vector<Triangle>& out) {
  std::vector<std::size_t> ring(face.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i;
  const auto is_ear = [&](std::size_t i) {
    const std::size_t n = ring.size(), before = ring[(i + n - 1) % n], at = ring[i], after = ring[(i + 1) % n];
    if (cross2(p[at] - p[before], p[after] - p[at]) <= 0) return false;
    return std::none_of(ring.begin(), ring.end(), [&](std::size_t k) {
      return k != before && k != at && k != after && p[k] != p[before] && p[k] != p[at] && p[k] != p[after] &&
             inside(p[k], p[before], p[at], p[after]);
    });
  };
  std::size_t from = 0;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    std::size_t ear = from % n;
    for (std::size_t tried = 0; tried < n; ++tried) {
      const std::size_t i = (from + tried) % n;
      if (is_ear(i)) {
        ear = i;
        break;
      }
    }
    out.push_back({face[ring[(ear + n - 1) % n]], face[ring[ear]], face[ring[(ear + 1) % n]]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    from = ear;  // the next corner: fans out of one vertex make slivers
  }
  out.push_back({face[ring[0]], face[ring[1]], face[ring[2]]});
}

}  // namespace

void triangulate_face(std::span<const Vec3> positions, std::span<const std::uint32_t> face,
                      std::vector<Triangle>& out) {
  if (face.size() < 3) return;
  const auto fan = [&] {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) out.push_back({face[0], face[i], face[i + 1]});
  };
  // Ear clipping takes quadratic time and more: a hostile face of a million corners gets a fan.
  constexpr std::size_t largest_clipped = 4096;
  if (face.size() == 3 || face.size() > largest_clipped) return fan();
  const std::vector<Vec2d> flat = project(positions, face);
  if (is_convex(flat)) return fan();
  clip_ears(flat, face, out);
}

}  // namespace lambert
