#include "vectors.h"

#include "lambert/base/transform.h"
#include "lambert/camera/camera.h"
#include "lambert/geometry/generators.h"
#include "lambert/geometry/shape.h"
#include "lambert/sampling/warp.h"
#include "lambert/scene/scene_graph.h"

#include <gtest/gtest.h>

#include <map>

namespace lambert {
namespace {

// rows: PG-48
const CheckOf bounds("V-PG-35", [](const Vector& v) {
  SceneGraph graph;
  const GeometryId cube = graph.add_geometry(box(Vec3(0), Vec3(1)));
  const MaterialId grey = graph.materials.add({.name = "grey"});
  std::map<std::string, NodeId> nodes{{"root", graph.root()}};
  nodes["a"] = graph.add_node(graph.root(), "a");
  for (const auto& [name, at] : v.input.at("leaf_unit_cubes_at").items()) {
    const NodeId parent = name.starts_with("leaf") ? nodes["a"] : graph.root();
    nodes[name] = graph.add_node(parent, name, Transform::translate(vec3(at)));
    graph.add_surface(nodes[name], {.geometry = cube, .material = grey});
  }
  graph.world_bounds(graph.root());

  for (const auto& [name, by] : v.input.at("move").items())
    graph.set_local_transform(nodes.at(name), Transform::translate(vec3(by)) * graph.local_transform(nodes.at(name)));
  const std::size_t before = graph.bounds_recomputed();
  const Bounds3 root = graph.world_bounds(graph.root());
  v.expect_near(root.min, v.expected.at("root_min"));
  v.expect_near(root.max, v.expected.at("root_max"));
  const auto& recomputed = v.expected.at("nodes_recomputed");
  EXPECT_EQ(graph.bounds_recomputed() - before, recomputed.size());
  for (const std::string name : recomputed) graph.world_bounds(nodes.at(name));
  EXPECT_EQ(graph.bounds_recomputed() - before, recomputed.size()) << "they are clean again";
});

// rows: IS-55 IS-56 IS-57
const CheckOf object_space("V-IS-24", [](const Vector& v) {
  const auto half = v.input.at("cube_half_extent_object").get<float>();
  const ConvexPolyhedron cube({{{1, 0, 0}, half},
                               {{-1, 0, 0}, half},
                               {{0, 1, 0}, half},
                               {{0, -1, 0}, half},
                               {{0, 0, 1}, half},
                               {{0, 0, -1}, half}});
  const Transform to_world = Transform::scale(Vec3(v.input.at("scale").get<float>()));
  const Ray world{vec3(v.input.at("start")), vec3(v.input.at("dir"))};
  const Ray object = to_world.inverse().ray(world);
  const float direction_length = length(object.direction);
  v.expect_near(object.origin, v.expected.at("start_os"));
  v.expect_near(direction_length, v.expected.at("length_dir_os"));

  const auto normalised = cube.intersect({object.origin, object.direction / direction_length});
  ASSERT_TRUE(normalised);
  v.expect_near(normalised->t, v.expected.at("t_os"));
  v.expect_near(normalised->t / direction_length, v.expected.at("t_ws"));
  // Not normalised, t means the same in both spaces.
  v.expect_near(cube.intersect(object)->t, v.expected.at("t_ws"));
  v.expect_near(to_world.point(normalised->position), v.expected.at("hit_ws"));
});

// rows: IS-58
const CheckOf normals("V-IS-25", [](const Vector& v) {
  Mat4 m(1);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      m[column][row] = v.input.at("C")[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)].get<float>();
  const Transform t(m);
  const Vec3 n = vec3(v.input.at("N_os"));
  const Vec3 world = normalize(t.normal(n));
  v.expect_near(world, v.expected.at("N_ws"));
  for (const Vec3 tangent : {Vec3(n.y, -n.x, 0), Vec3(0, 0, 1)})
    v.expect_near(dot(world, t.vector(tangent)), v.expected.at("dot_with_tangent"));
});

// rows: PT-32
// The numbers are in its title: lens at the origin, plane of focus at z = 4, pinhole direction (1, 0, 2), lens point
// (.1, .2, 0). The camera looks along +z by a mirrored frame.
const CheckOf thin_lens("V-PT-15", [](const Vector& v) {
  const Vec3 origin = vec3(v.expected.at("origin"));
  Camera camera;
  camera.to_world = Transform::scale({1, 1, -1});
  camera.projection = Perspective{.half_width = 1, .half_height = 1, .lens_radius = 0.5f, .focal_distance = 4};
  camera.resolution = {8, 8};
  const Vec2 film(6, 4);  // x / z = 1/2
  const Vec2 u_lens = uniform_disk_concentric_to_square(Vec2(origin) / 0.5f);
  const Ray ray = camera.ray(film, u_lens).ray;
  v.expect_near(ray.origin, v.expected.at("origin"));
  v.expect_near(ray.direction, v.expected.at("direction"));
  v.expect_near(ray.at(4 / ray.direction.z), v.expected.at("focal_point"));
  const Ray centre = camera.ray(film).ray;
  v.expect_near(centre.direction / centre.direction.z, nlohmann::json{0.5, 0, 1});
});

}  // namespace
}  // namespace lambert
