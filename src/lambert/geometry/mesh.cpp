#include "lambert/geometry/mesh.h"

#include "lambert/base/error.h"

#include <algorithm>
#include <cmath>

namespace lambert {
namespace {

std::string label(const TriangleMesh& mesh) { return "mesh '" + mesh.name + "'"; }

template <class T>
void check_array(const TriangleMesh& mesh, const char* array, const std::vector<T>& values) {
  if (!values.empty() && values.size() != mesh.positions.size())
    throw Error(label(mesh) + ": " + array + " has " + std::to_string(values.size()) +
                " entries, expected one for each of " + std::to_string(mesh.positions.size()) + " positions");
  for (std::size_t i = 0; i < values.size(); ++i) {
    // x - x is 0 for finite numbers and NaN for all others.
    const T zero = values[i] - values[i];
    if (zero != T(0)) throw Error(label(mesh) + ": " + array + "[" + std::to_string(i) + "] is not finite");
  }
}

float angle_between(Vec3 a, Vec3 b) {
  const float l = length(a) * length(b);
  return l > 0 ? std::acos(std::clamp(dot(a, b) / l, -1.0f, 1.0f)) : 0;
}

}  // namespace

Bounds3 TriangleMesh::bounds() const {
  Bounds3 box;
  for (const Vec3 p : positions) box.add(p);
  return box;
}

float TriangleMesh::area() const {
  double twice = 0;
  for (const Triangle& t : triangles)
    twice += static_cast<double>(length(cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]])));
  return static_cast<float>(0.5 * twice);
}

float TriangleMesh::volume() const {
  if (positions.empty()) return 0;
  // Tetrahedra with an apex near the surface: far from the origin no digits are lost.
  const Vec3d apex(positions[0]);
  double six_times = 0;
  for (const Triangle& t : triangles) {
    const Vec3d a = Vec3d(positions[t[0]]) - apex, b = Vec3d(positions[t[1]]) - apex, c = Vec3d(positions[t[2]]) - apex;
    six_times += dot(a, cross(b, c));
  }
  return static_cast<float>(six_times / 6);
}

bool is_closed(const TriangleMesh& mesh) {
  struct Edge {
    std::array<float, 6> ends;  // the lesser first
    int direction;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  const auto place = [&](std::uint32_t v) {
    const Vec3 p = mesh.positions[v] + 0.0f;  // one zero of two
    return std::array<float, 3>{p.x, p.y, p.z};
  };
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = place(t[i]), to = place(t[(i + 1) % 3]);
      if (from == to) return false;
      const auto &low = std::min(from, to), &high = std::max(from, to);
      edges.push_back({{low[0], low[1], low[2], high[0], high[1], high[2]}, from < to ? 1 : -1});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  for (std::size_t i = 0; i < edges.size();) {
    int balance = 0;
    const auto ends = edges[i].ends;
    for (; i < edges.size() && edges[i].ends == ends; ++i) balance += edges[i].direction;
    if (balance != 0) return false;
  }
  return true;
}

void validate(const TriangleMesh& mesh) {
  check_array(mesh, "positions", mesh.positions);
  check_array(mesh, "normals", mesh.normals);
  check_array(mesh, "tangents", mesh.tangents);
  check_array(mesh, "uvs", mesh.uvs);
  check_array(mesh, "uvs1", mesh.uvs1);
  check_array(mesh, "colours", mesh.colours);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t v : mesh.triangles[i])
      if (v >= mesh.positions.size())
        throw Error(label(mesh) + ": triangle " + std::to_string(i) + " names vertex " + std::to_string(v) +
                    ", expected less than " + std::to_string(mesh.positions.size()));
}

TriangleMesh transformed(TriangleMesh mesh, const Transform& t) {
  if (t.is_identity()) return mesh;
  const auto unit = [](Vec3 v) {
    const float l = length(v);
    return l > 0 ? v / l : v;
  };
  for (Vec3& p : mesh.positions) p = t.point(p);
  for (Vec3& n : mesh.normals) n = unit(t.normal(n));
  const bool mirrored = t.swaps_handedness();
  for (Vec4& tangent : mesh.tangents) tangent = Vec4(unit(t.vector(Vec3(tangent))), mirrored ? -tangent.w : tangent.w);
  if (mirrored)
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

void compute_smooth_normals(TriangleMesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), Vec3(0));
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const Vec3 n = cross(b - a, c - a);
    const float l = length(n);
    if (!(l > 0)) continue;
    mesh.normals[t[0]] += n / l * angle_between(b - a, c - a);
    mesh.normals[t[1]] += n / l * angle_between(c - b, a - b);
    mesh.normals[t[2]] += n / l * angle_between(a - c, b - c);
  }
  for (Vec3& n : mesh.normals) {
    const float l = length(n);
    n = l > 0 ? n / l : Vec3(0, 0, 1);
  }
}

}  // namespace lambert
