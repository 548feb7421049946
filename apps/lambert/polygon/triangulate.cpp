#include "mesh_output.h"
#include "places.h"
#include "triangles.h"

#include "../command.h"

#include "lambert/formats/write_mesh.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

/// All features in one flat mesh that faces +z.
TriangleMesh flat_mesh(const std::vector<FeatureTriangles>& meshes) {
  TriangleMesh all;
  for (const FeatureTriangles& mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const Vec2d p : mesh.vertices) all.positions.emplace_back(p.x, p.y, 0);
    for (const auto& [a, b, c] : mesh.triangles) all.triangles.push_back({first + a, first + b, first + c});
  }
  all.normals.assign(all.positions.size(), Vec3(0, 0, 1));
  return all;
}

int run(const TriangulateOptions& o) {
  check_geometry_outputs(o);
  const std::vector<PolygonInput> inputs = read_inputs(o, {.validity = true});
  Picture picture;
  std::vector<Rings> shown;
  std::vector<FeatureTriangles> meshes;
  const Features result = cut_from(joined(inputs), [&](const Feature& source, Feature& feature) {
    meshes.push_back(triangulated(source, o));
    Rings triangles;
    for (const polygon::Triangle& t : meshes.back().triangles) triangles.push_back(corners(meshes.back(), t));
    feature.polygons = polygons_of(triangles);
    for (Ring& t : triangles) shown.push_back({std::move(t)});
  });
  show_pieces(picture, shown);
  for (const FeatureTriangles& mesh : meshes) add_vertex_numbers(picture, mesh);
  picture.title = "triangulate, " + o.method + ": " + counted(shown.size(), "triangle");
  PolygonOptions rest = o;
  if (write_meshes(rest, [&] { return flat_mesh(meshes); })) return done;
  write_geometry(rest, inputs.front().format, result, picture);
  return done;
}

}  // namespace

std::function<int()> add_triangulate(CLI::App& app) {
  static TriangulateOptions options;
  options.meshes = mesh_extensions();
  add_input_options(app, options);
  add_method(app, options);
  add_geometry_outputs(app, options);
  app.footer("-o may also name a mesh: .ply .obj .glb.");
  return [] { return run(options); };
}

}  // namespace lambert::cli
