#include "mesh_output.h"
#include "places.h"

#include "../command.h"
#include "../number_range.h"
#include "../outputs.h"

#include "lambert/base/error.h"
#include "lambert/base/standard_streams.h"
#include "lambert/formats/write_mesh.h"
#include "lambert/geometry/extrude.h"
#include "lambert/geometry/revolve.h"
#include "lambert/polygon/boolean/boolean.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

struct ExtrudeOptions : PolygonOptions {
  std::string along = "0,0,1";
  float crease = 30;
};
struct RevolveOptions : PolygonOptions {
  std::string origin = "0,0,0", axis = "0,1,0", reference = "1,0,0";
  float sweep = 360, start = 0, crease = 30;
  int steps = 32;
};

Vec3d parse_vector(const std::string& flag, const std::string& text) {
  const std::vector<double> n = parse_reals(flag, text, 3, "X,Y,Z");
  return {n[0], n[1], n[2]};
}

/// To the files of -o, or as OBJ text to standard output.
int write_solid(PolygonOptions o, const TriangleMesh& mesh) {
  if (o.outputs.empty()) {
    fmt::print("{}", obj_of(mesh));
    return done;
  }
  std::ranges::replace(o.outputs, "-", "obj:-");
  const std::vector<std::string> known = mesh_extensions();
  for (const std::string& path : o.outputs) {
    const std::string extension = format_extension(path);
    if (std::ranges::find(known, extension) == known.end())
      throw Error(path + ": unknown extension " + unknown_word(extension, known));
  }
  check_texts(o.outputs);
  write_meshes(o, [&] { return mesh; });
  return done;
}

void append(TriangleMesh& all, const TriangleMesh& more) {
  const auto first = static_cast<std::uint32_t>(all.positions.size());
  all.positions.insert(all.positions.end(), more.positions.begin(), more.positions.end());
  all.normals.insert(all.normals.end(), more.normals.begin(), more.normals.end());
  all.uvs.insert(all.uvs.end(), more.uvs.begin(), more.uvs.end());
  for (const auto& [a, b, c] : more.triangles) all.triangles.push_back({first + a, first + b, first + c});
}

int run_extrude(const ExtrudeOptions& o) {
  const Extrusion settings{.along = parse_vector("--along", o.along), .crease = degrees(o.crease)};
  const std::vector<PolygonInput> inputs = read_inputs(o, {.validity = true});
  const Regions regions = normalised(rings_of(joined(inputs)), fill_rule(o));
  if (regions.empty()) throw Error("extrude: the polygons enclose nothing");
  return write_solid(o, extrude(regions, settings));
}

int run_revolve(const RevolveOptions& o) {
  const Revolution settings{.origin = parse_vector("--origin", o.origin),
                            .axis = parse_vector("--axis", o.axis),
                            .reference = parse_vector("--reference", o.reference),
                            .start = degrees(o.start),
                            .sweep = degrees(o.sweep),
                            .steps = o.steps,
                            .crease = degrees(o.crease)};
  const std::vector<PolygonInput> inputs = read_inputs(o, {.lines = true, .line_heights = true, .validity = true});
  TriangleMesh mesh;
  for (const Feature& feature : joined(inputs).features) {
    for (const Region& region : normalised(rings_of(feature), fill_rule(o))) append(mesh, revolve(region, settings));
    for (const Path& line : feature.lines) append(mesh, revolve(in_space(line), settings));
  }
  if (mesh.triangles.empty()) throw Error("revolve: expected polygons that enclose something, or lines");
  return write_solid(o, mesh);
}

}  // namespace

std::function<int()> add_extrude(CLI::App& app) {
  static ExtrudeOptions options;
  add_input_options(app, options);
  app.add_option("--along", options.along, "Where to move the polygon, X,Y,Z")->capture_default_str();
  expect_number(
      app.add_option("--crease", options.crease, "Sides that turn by fewer degrees look smooth")->capture_default_str(),
      angle_in_degrees(0, 180));
  add_outputs(app, options.outputs, "Write the mesh: .ply .obj .glb; else OBJ is printed");
  app.footer("A closed prism with caps, normals and texture coordinates.");
  return [] { return run_extrude(options); };
}

std::function<int()> add_revolve(CLI::App& app) {
  static RevolveOptions options;
  add_input_options(app, options);
  app.add_option("--axis", options.axis, "Direction of the axis, X,Y,Z")->capture_default_str();
  app.add_option("--origin", options.origin, "A point of the axis")->capture_default_str();
  app.add_option("--reference", options.reference, "Where the x of a polygon points at the start")
      ->capture_default_str();
  expect_number(app.add_option("--sweep", options.sweep, "Degrees to turn by")->capture_default_str(),
                {.expected = "an angle above 0 and at most 360 degrees", .low = 1e-6, .below = 360.00001});
  expect_number(app.add_option("--start", options.start, "Degrees to start at")->capture_default_str(),
                angle_in_degrees(-360, 360));
  expect_number(app.add_option("--steps", options.steps, "Positions around")->capture_default_str(),
                whole_number(1, 1 << 24));
  expect_number(app.add_option("--crease", options.crease, "Strips that turn by fewer degrees look smooth")
                    ->capture_default_str(),
                angle_in_degrees(0, 180));
  add_outputs(app, options.outputs, "Write the mesh: .ply .obj .glb; else OBJ is printed");
  app.footer(
      "Of a polygon, x is the distance from the axis and y the height: a solid. A line, which may have a third\n"
      "coordinate, leaves a surface where it is.");
  return [] { return run_revolve(options); };
}

}  // namespace lambert::cli
