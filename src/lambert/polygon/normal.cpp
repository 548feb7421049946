#include "lambert/polygon/normal.h"

#include "lambert/polygon/predicates.h"
#include "lambert/polygon/scale.h"

#include <algorithm>
#include <cmath>

namespace lambert::polygon {
namespace {

/// Scaled first, so that squares of very large or small components neither overflow nor vanish.
std::optional<Vec3d> unit(Vec3d v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
  return normalize(v / largest);
}

bool collinear(Vec3d a, Vec3d b, Vec3d c) {
  return orientation({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0 && orientation({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == 0 &&
         orientation({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == 0;
}

/// newell_sum(), `scale` squared times as large.
struct ScaledSum {
  Vec3d sum;
  double scale;
};
ScaledSum scaled_sum(std::span<const Vec3d> vertices) {
  double most = 0;
  for (const Vec3d v : vertices) most = std::max(most, largest_component(v));
  const double scale = unit_scale(most);
  return {newell_sum(vertices.size(), [&](std::size_t i) { return scale * vertices[i]; }), scale};
}

/// The first vertex that is not on one line with the first and `second`, which are different.
template <class Iterator>
Iterator off_the_line(std::span<const Vec3d> vertices, Iterator second) {
  return std::find_if(second, vertices.end(), [&](Vec3d v) { return !collinear(vertices[0], *second, v); });
}

}  // namespace

std::optional<Vec3d> plane_normal(double a, double b, double c) { return unit({a, b, c}); }

std::optional<Vec3d> three_vertex_normal(std::span<const Vec3d> vertices) {
  const auto second = std::find_if(vertices.begin(), vertices.end(), [&](Vec3d v) { return v != vertices[0]; });
  const auto third = second == vertices.end() ? second : off_the_line(vertices, second);
  if (third == vertices.end()) return std::nullopt;
  const double scale =
      unit_scale(std::max({largest_component(vertices[0]), largest_component(*second), largest_component(*third)}));
  const Vec3d a = scale * vertices[0], b = scale * *second, c = scale * *third;
  return unit(cross(b - a, c - b));
}

bool on_one_line(std::span<const Vec3d> vertices) { return !three_vertex_normal(vertices); }

std::optional<Vec3d> newell_normal(std::span<const Vec3d> vertices) { return unit(scaled_sum(vertices).sum); }

double face_area(std::span<const Vec3d> vertices) {
  const auto [sum, scale] = scaled_sum(vertices);
  return 0.5 * safe_length(sum) / scale / scale;
}

double out_of_plane_sine(std::span<const Vec3d> vertices) {
  const auto normal = newell_normal(vertices);
  if (!normal) return 1;
  double largest = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (const auto edge = unit(0.5 * vertices[next_index(i, vertices.size())] - 0.5 * vertices[i]))
      largest = std::max(largest, std::abs(dot(*edge, *normal)));
  return largest;
}

PlaneProjection::PlaneProjection(Vec3d normal) : axis_(dominant_axis(normal)) {
  const bool mirrored = normal[axis_] < 0;
  first_ = (axis_ + (mirrored ? 2 : 1)) % 3, second_ = (axis_ + (mirrored ? 1 : 2)) % 3;
}

Ring PlaneProjection::operator()(std::span<const Vec3d> vertices) const {
  Ring flat;
  flat.reserve(vertices.size());
  for (const Vec3d v : vertices) flat.push_back((*this)(v));
  return flat;
}

}  // namespace lambert::polygon
