#include "lambert/scene/cornell_box.h"

#include "lambert/material/spectrum.h"

#include <array>

namespace lambert {
namespace {

// Measured from 400 to 700 nm in steps of 4 nm at Cornell; here every fifth value (20 nm).
SpectrumSamples every_20_nm(const std::array<float, 16>& values) {
  SpectrumSamples s;
  for (std::size_t i = 0; i < values.size(); ++i) s.emplace_back(400.0f + 20.0f * static_cast<float>(i), values[i]);
  return s;
}
const std::array<float, 16> white_reflectance{0.343f, 0.611f, 0.699f, 0.724f, 0.721f, 0.721f, 0.727f, 0.734f,
                                              0.743f, 0.745f, 0.740f, 0.741f, 0.741f, 0.739f, 0.737f, 0.737f};
const std::array<float, 16> green_reflectance{0.092f, 0.096f, 0.098f, 0.107f, 0.151f, 0.254f, 0.410f, 0.481f,
                                              0.433f, 0.344f, 0.258f, 0.191f, 0.153f, 0.139f, 0.144f, 0.159f};
const std::array<float, 16> red_reflectance{0.040f, 0.052f, 0.054f, 0.053f, 0.054f, 0.057f, 0.058f, 0.057f,
                                            0.061f, 0.076f, 0.197f, 0.453f, 0.606f, 0.635f, 0.642f, 0.642f};

/// Wavelength and radiance of the lamp.
const SpectrumSamples lamp_spectrum{{400, 0.0f}, {500, 8.0f}, {600, 15.6f}, {700, 18.4f}};

constexpr float millimetre = 1e-3f;

/// The published coordinates have x to the left, y up and z into the room; here x runs to the right and z out of it.
Vec3 place(Vec3 measured) { return millimetre * Vec3(-measured.x, measured.y, -measured.z); }

/// Counter-clockwise seen from the side that the published vertex order faces, which the turn above keeps.
GeometryId quad(SceneGraph& graph, const std::array<Vec3, 4>& corners) {
  TriangleMesh mesh;
  for (const Vec3 c : corners) mesh.positions.push_back(place(c));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return graph.add_geometry(std::move(mesh));
}

struct Wall {
  const char* name;
  MaterialId material;
  std::vector<std::array<Vec3, 4>> quads;
};

void add(SceneGraph& graph, const Wall& wall) {
  const NodeId node = graph.add_node(graph.root(), wall.name);
  for (const auto& q : wall.quads) graph.add_surface(node, {.geometry = quad(graph, q), .material = wall.material});
}

MaterialId diffuse(SceneGraph& graph, const char* name, Rgb reflectance) {
  return graph.materials.add({.name = name, .model = DiffuseMaterial{RgbParameter{reflectance}}});
}

}  // namespace

SceneGraph cornell_box() {
  SceneGraph graph;
  graph.name = "Cornell box";
  const MaterialId white = diffuse(graph, "white", spectrum_to_reflectance_rgb(every_20_nm(white_reflectance)));
  const MaterialId green = diffuse(graph, "green", spectrum_to_reflectance_rgb(every_20_nm(green_reflectance)));
  const MaterialId red = diffuse(graph, "red", spectrum_to_reflectance_rgb(every_20_nm(red_reflectance)));
  const MaterialId lamp = diffuse(graph, "lamp", Rgb(0.78f));

  add(graph, {"floor", white, {{Vec3(552.8f, 0, 0), {0, 0, 0}, {0, 0, 559.2f}, {549.6f, 0, 559.2f}}}});
  add(graph, {"ceiling", white, {{Vec3(556, 548.8f, 0), {556, 548.8f, 559.2f}, {0, 548.8f, 559.2f}, {0, 548.8f, 0}}}});
  add(graph,
      {"back wall", white, {{Vec3(549.6f, 0, 559.2f), {0, 0, 559.2f}, {0, 548.8f, 559.2f}, {556, 548.8f, 559.2f}}}});
  add(graph, {"right wall", green, {{Vec3(0, 0, 559.2f), {0, 0, 0}, {0, 548.8f, 0}, {0, 548.8f, 559.2f}}}});
  add(graph, {"left wall", red, {{Vec3(552.8f, 0, 0), {549.6f, 0, 559.2f}, {556, 548.8f, 559.2f}, {556, 548.8f, 0}}}});
  add(graph, {"short block",
              white,
              {{Vec3(130, 165, 65), {82, 165, 225}, {240, 165, 272}, {290, 165, 114}},
               {Vec3(290, 0, 114), {290, 165, 114}, {240, 165, 272}, {240, 0, 272}},
               {Vec3(130, 0, 65), {130, 165, 65}, {290, 165, 114}, {290, 0, 114}},
               {Vec3(82, 0, 225), {82, 165, 225}, {130, 165, 65}, {130, 0, 65}},
               {Vec3(240, 0, 272), {240, 165, 272}, {82, 165, 225}, {82, 0, 225}}}});
  add(graph, {"tall block",
              white,
              {{Vec3(423, 330, 247), {265, 330, 296}, {314, 330, 456}, {472, 330, 406}},
               {Vec3(423, 0, 247), {423, 330, 247}, {472, 330, 406}, {472, 0, 406}},
               {Vec3(472, 0, 406), {472, 330, 406}, {314, 330, 456}, {314, 0, 456}},
               {Vec3(314, 0, 456), {314, 330, 456}, {265, 330, 296}, {265, 0, 296}},
               {Vec3(265, 0, 296), {265, 330, 296}, {423, 330, 247}, {423, 0, 247}}}});

  // The lamp fills an opening of the ceiling; here it hangs 0.2 mm below it.
  const NodeId node = graph.add_node(graph.root(), "lamp");
  Surface surface{
      .geometry = quad(graph, {Vec3(343, 548.6f, 227), {343, 548.6f, 332}, {213, 548.6f, 332}, {213, 548.6f, 227}}),
      .material = lamp};
  surface.emission = Emission{.radiance = RgbParameter{spectrum_to_emission_rgb(lamp_spectrum)}};
  graph.add_surface(node, surface);

  // Focal length 35 mm, film 25 x 25 mm.
  Camera camera{.name = "camera"};
  camera.to_world = Transform::look_at(place({278, 273, -800}), place({278, 273, 0}), {0, 1, 0});
  camera.projection = Perspective{.half_width = 0.0125f / 0.035f, .half_height = 0.0125f / 0.035f};
  camera.resolution = {512, 512};
  graph.add_camera(camera);
  return graph;
}

}  // namespace lambert
