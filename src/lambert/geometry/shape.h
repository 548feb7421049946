#pragma once
/// Analytic shapes in their own space. They are intersected as they are, never tessellated.

#include "lambert/base/bounds.h"
#include "lambert/base/ray.h"
#include "lambert/base/vec.h"
#include "lambert/geometry/mesh.h"
#include "lambert/sampling/distribution.h"

#include <concepts>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace lambert {

struct ShapeHit {
  float t = 0;           ///< in lengths of the ray's direction
  Vec3 position{0};      ///< on the surface: nearer to it than ray.at(t) when the ray comes from far
  Vec3 normal{0, 0, 1};  ///< unit, outward
  Vec3 dpdu{1, 0, 0};    ///< ∂position/∂u
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

/// A planar simple polygon, counter-clockwise seen from its normal's side (row PG-67). Its uv span the bounding
/// rectangle of its projection along the dominant axis of its normal.
struct Polygon {
  /// Throws Error when there are fewer than 3 vertices, or they are not finite, on one line or not in one plane.
  explicit Polygon(std::vector<Vec3> vertices);
  std::optional<ShapeHit> intersect(const Ray& ray) const;
  Bounds3 bounds() const { return bounds_; }
  float area() const { return area_; }
  ShapeSample sample(Vec2 u) const;
  const std::vector<Vec3>& vertices() const { return vertices_; }
  Vec3 normal() const { return normal_; }
  /// What a ray finds that meets the polygon at `position`.
  ShapeHit hit_at(float t, Vec3 position) const;

 private:
  Vec2 uv_at(Vec3 position) const;

  std::vector<Vec3> vertices_;
  Bounds3 bounds_;
  Vec3 normal_;
  int drop_axis_;
  std::vector<Triangle> triangles_;  // for sampling
  DiscreteDistribution triangle_choice_;
  float area_;
};

/// The intersection of half-spaces dot(normal, p) <= offset (row PG-68, slab method). Each face has a polygon's uv.
struct ConvexPolyhedron {
  struct Plane {
    Vec3 normal{0, 0, 1};
    float offset = 0;
  };
  explicit ConvexPolyhedron(std::vector<Plane> planes);  ///< throws Error when unbounded or empty
  std::optional<ShapeHit> intersect(const Ray& ray) const;
  Bounds3 bounds() const { return bounds_; }
  float area() const { return area_; }
  ShapeSample sample(Vec2 u) const;
  std::size_t face_count() const { return faces_.size(); }  ///< planes that merely touch the body have none

 private:
  struct Face {
    Vec3d normal;
    double offset;
    Polygon polygon;
  };
  static std::vector<Face> make_faces(const std::vector<Plane>& planes);

  std::vector<Face> faces_;
  DiscreteDistribution face_choice_;
  Bounds3 bounds_;
  float area_ = 0;
};

template <ShapeModel... Shapes>
using ShapeVariant = std::variant<Shapes...>;
using Shape = ShapeVariant<Sphere, Disk, Cylinder, Polygon, ConvexPolyhedron>;

}  // namespace lambert
