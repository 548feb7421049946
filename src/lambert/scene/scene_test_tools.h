#pragma once
/// What the tests of scenes share.

#include "lambert/geometry/generators.h"
#include "lambert/geometry/shape_test_tools.h"
#include "lambert/scene/scene.h"

namespace lambert {

inline MaterialId add_grey(SceneGraph& graph, float reflectance = 0.5f) {
  return graph.materials.add({.name = "grey", .model = DiffuseMaterial{RgbParameter{Rgb(reflectance)}}});
}

inline TriangleMesh rectangle(Vec3 corner, Vec3 u, Vec3 v) {
  TriangleMesh mesh;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return mesh;
}

/// A turn, a stretch, perhaps a mirroring, and a move.
inline Transform random_placement(Random& random, bool mirror) {
  const Vec3 stretch(random.between(0.5f, 2), random.between(0.5f, 2), random.between(0.5f, 2));
  return Transform::translate(random.cube(4)) * Transform::rotate(degrees(random.between(0, 360)), random.direction()) *
         Transform::scale(mirror ? Vec3(-1, 1, 1) * stretch : stretch);
}

inline std::optional<Hit> nearest(const Scene& scene, const Ray& ray) {
  Hit hit;
  return scene.intersect(ray, hit) ? std::optional(hit) : std::nullopt;
}

}  // namespace lambert
