#include "known_scenes.h"

namespace lambert {
namespace {

MaterialId add_diffuse(SceneGraph& graph, float albedo) {
  return graph.materials.add({.name = "grey", .model = DiffuseMaterial{RgbParameter{Rgb(albedo)}}});
}

TriangleMesh rectangle(Vec3 corner, Vec3 u, Vec3 v) {
  TriangleMesh mesh;
  mesh.positions = {corner, corner + u, corner + u + v, corner + v};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Sphere full_sphere(float radius) { return {.radius = radius, .z_min = -radius, .z_max = radius}; }

}  // namespace

SceneGraph furnace(float albedo, float emission) {
  SceneGraph graph;
  Surface wall{.geometry = graph.add_geometry(Shape(full_sphere(1))), .material = add_diffuse(graph, albedo)};
  wall.emission = Emission{.radiance = RgbParameter{Rgb(emission)}};
  wall.reverse_orientation = true;
  graph.add_surface(graph.root(), wall);
  return graph;
}

SceneGraph point_light_in_sphere(float albedo, float intensity, float radius) {
  SceneGraph graph;
  graph.add_surface(graph.root(), {.geometry = graph.add_geometry(Shape(full_sphere(radius))),
                                   .material = add_diffuse(graph, albedo)});
  graph.add_light(PointLight{.position = Vec3(0), .intensity = Rgb(intensity)});
  return graph;
}

SceneGraph lamp_over_floor(float albedo, float radiance) {
  SceneGraph graph;
  const NodeId floor = graph.add_node(graph.root(), "floor"), lamp = graph.add_node(graph.root(), "lamp");
  graph.add_surface(floor, {.geometry = graph.add_geometry(rectangle({-5, 0, -5}, {0, 0, 10}, {10, 0, 0})),
                            .material = add_diffuse(graph, albedo)});
  Surface emitter{.geometry = graph.add_geometry(rectangle({-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1})),
                  .material = add_diffuse(graph, 0)};
  emitter.emission = Emission{.radiance = RgbParameter{Rgb(radiance)}};
  graph.add_surface(lamp, emitter);
  return graph;
}

SceneGraph floor_under(float albedo, Geometry lamp, const Transform& place, float radiance) {
  SceneGraph graph;
  graph.add_surface(graph.root(), {.geometry = graph.add_geometry(rectangle({-5, 0, -5}, {0, 0, 10}, {10, 0, 0})),
                                   .material = add_diffuse(graph, albedo)});
  Surface emitter{.geometry = graph.add_geometry(std::move(lamp)), .material = add_diffuse(graph, 0)};
  emitter.emission = Emission{.radiance = RgbParameter{Rgb(radiance)}, .two_sided = true};
  graph.add_surface(graph.add_node(graph.root(), "lamp", place), emitter);
  return graph;
}

SceneGraph floor_under_sky(float albedo, float radiance) {
  SceneGraph graph;
  graph.add_surface(graph.root(), {.geometry = graph.add_geometry(rectangle({-5, 0, -5}, {0, 0, 10}, {10, 0, 0})),
                                   .material = add_diffuse(graph, albedo)});
  graph.add_light(EnvironmentLight(Rgb(radiance)));
  return graph;
}

std::vector<Camera> cameras_at(Vec3 position, Vec3 target) {
  const Vec2i resolution(8, 8);
  const Vec3 up = std::abs(normalize(target - position).y) > 0.9f ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  const Transform place = Transform::look_at(position, target, up);
  Perspective lens = perspective(degrees(1), FovAxis::shorter, resolution);
  lens.lens_radius = 0.001f, lens.focal_distance = length(target - position);
  return {
      {.name = "perspective",
       .to_world = place,
       .projection = perspective(degrees(1), FovAxis::shorter, resolution),
       .resolution = resolution},
      {.name = "thin lens", .to_world = place, .projection = lens, .resolution = resolution},
      {.name = "orthographic",
       .to_world = place,
       .projection = Orthographic{.half_width = 0.01f, .half_height = 0.01f},
       .resolution = resolution},
      {.name = "panoramic", .to_world = place, .projection = Panoramic{}, .resolution = resolution},
  };
}

}  // namespace lambert
