#pragma once
/// Analytic shapes in their own space. They are intersected as they are, never tessellated.

#include "lambert/base/bounds.h"
#include "lambert/base/ray.h"
#include "lambert/base/vec.h"

#include <array>
#include <concepts>
#include <optional>
#include <variant>
#include <vector>

namespace lambert {

struct ShapeHit {
  float t = 0;           ///< in lengths of the ray's direction
  Vec3 normal{0, 0, 1};  ///< unit, outward
  Vec3 dpdu{1, 0, 0};    ///< along +u, not normalised
  Vec2 uv{0};            ///< in [0,1]²
};

/// A point drawn uniformly by area: its density is 1 / area().
struct ShapeSample {
  Vec3 position{0};
  Vec3 normal{0, 0, 1};
  Vec2 uv{0};
};

template <class T>
concept ShapeModel = requires(const T& s, const Ray& r, Vec2 u) {
  { s.intersect(r) } -> std::same_as<std::optional<ShapeHit>>;  // nearest hit in [t_min, t_max]
  { s.bounds() } -> std::same_as<Bounds3>;
  { s.area() } -> std::same_as<float>;
  { s.sample(u) } -> std::same_as<ShapeSample>;
};

/// About the origin, axis z, clipped to z_min..z_max and to phi in [0, phi_max] (pbrt's parameterisation).
struct Sphere {
  float radius = 1;
  float z_min = -1, z_max = 1;  ///< the full sphere when they reach ±radius
  float phi_max = 6.283185307f;
  bool is_full() const { return z_min <= -radius && z_max >= radius && phi_max >= 6.2831f; }
  std::optional<ShapeHit> intersect(const Ray& ray) const;
  Bounds3 bounds() const;
  float area() const;
  ShapeSample sample(Vec2 u) const;
};

/// In the plane z = height, normal +z, between two radii.
struct Disk {
  float height = 0, radius = 1, inner_radius = 0, phi_max = 6.283185307f;
  std::optional<ShapeHit> intersect(const Ray& ray) const;
  Bounds3 bounds() const;
  float area() const;
  ShapeSample sample(Vec2 u) const;
};

/// About the z axis, with or without its two caps (row PG-70).
struct Cylinder {
  float radius = 1, z_min = -1, z_max = 1, phi_max = 6.283185307f;
  bool caps = false;
  std::optional<ShapeHit> intersect(const Ray& ray) const;
  Bounds3 bounds() const;
  float area() const;
  ShapeSample sample(Vec2 u) const;
};

/// A planar simple polygon, counter-clockwise seen from its normal's side (row PG-67).
struct Polygon {
  explicit Polygon(std::vector<Vec3> vertices);  ///< throws Error when fewer than 3, degenerate or not planar
  std::optional<ShapeHit> intersect(const Ray& ray) const;
  Bounds3 bounds() const;
  float area() const;
  ShapeSample sample(Vec2 u) const;
  const std::vector<Vec3>& vertices() const { return vertices_; }

 private:
  std::vector<Vec3> vertices_;
  std::vector<std::array<std::size_t, 3>> triangles_;  // for sampling
  std::vector<float> cumulative_area_;
  Vec3 normal_{0, 0, 1};
  int drop_axis_ = 2;
};

/// The intersection of half-spaces dot(normal, p) <= offset (row PG-68, slab method).
struct ConvexPolyhedron {
  struct Plane {
    Vec3 normal{0, 0, 1};
    float offset = 0;
  };
  explicit ConvexPolyhedron(std::vector<Plane> planes);  ///< throws Error when unbounded or empty
  std::optional<ShapeHit> intersect(const Ray& ray) const;
  Bounds3 bounds() const;
  float area() const;
  ShapeSample sample(Vec2 u) const;

 private:
  std::vector<Plane> planes_;
  std::vector<Polygon> faces_;
  std::vector<float> cumulative_area_;
  Bounds3 bounds_;
};

template <ShapeModel... Shapes>
using ShapeVariant = std::variant<Shapes...>;
using Shape = ShapeVariant<Sphere, Disk, Cylinder, Polygon, ConvexPolyhedron>;

}  // namespace lambert
