#include "mesh_output.h"
#include "places.h"

#include "../command.h"

#include "lambert/base/error.h"
#include "lambert/polygon/boolean.h"
#include "lambert/polygon/delaunay.h"
#include "lambert/polygon/ear_clipping.h"
#include "lambert/polygon/strips.h"
#include "lambert/polygon/triangulate.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

struct Options : PolygonOptions {
  std::string method = "delaunay";
};

/// The triangles of one feature and the vertices that they number.
struct Mesh {
  Rings rings;
  std::vector<Vec2d> vertices;
  std::vector<polygon::Triangle> triangles;
};

std::vector<polygon::Triangle> ears_of(const Regions& regions) {
  std::vector<polygon::Triangle> triangles;
  std::uint32_t first = 0;
  for (const Region& region : regions) {
    if (!region.holes.empty())
      throw Error("--method ears: takes polygons without holes; delaunay and sweep take holes");
    for (const auto& [a, b, c] : clip_ears(region.outer)) triangles.push_back({first + a, first + b, first + c});
    first += static_cast<std::uint32_t>(region.outer.size());
  }
  return triangles;
}

Mesh triangulated(const Feature& feature, const Options& o) {
  const Regions regions = normalised(rings_of(feature), fill_rule(o));
  const Rings rings = rings_of(regions);
  const FlatRings numbered = flat(rings);
  if (o.method == "delaunay") return {rings, numbered.vertices, delaunay(numbered)};
  if (o.method == "sweep") return {rings, numbered.vertices, triangulate(numbered)};
  if (o.method == "ears") return {rings, numbered.vertices, ears_of(regions)};
  throw Error("--method: unknown method " + unknown_word(o.method, {"delaunay", "sweep", "ears"}));
}

Ring corners(const Mesh& mesh, const polygon::Triangle& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

void add_vertex_numbers(Picture& picture, const Mesh& mesh) {
  std::size_t first = 0;
  for (const Ring& ring : mesh.rings) {
    add_indices(picture, {ring}, ink, first);
    first += ring.size();
  }
}

/// All features in one flat mesh that faces +z.
TriangleMesh flat_mesh(const std::vector<Mesh>& meshes) {
  TriangleMesh all;
  for (const Mesh& mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const Vec2d p : mesh.vertices) all.positions.emplace_back(p.x, p.y, 0);
    for (const auto& [a, b, c] : mesh.triangles) all.triangles.push_back({first + a, first + b, first + c});
  }
  all.normals.assign(all.positions.size(), Vec3(0, 0, 1));
  return all;
}

int run_triangulate(const Options& o) {
  const std::vector<PolygonInput> inputs = read_inputs(o);
  note_what_counts_not(inputs);
  const Features all = joined(inputs);
  Features result;
  result.members = all.members, result.srid = all.srid;
  Picture picture;
  std::vector<Rings> shown;
  std::vector<Mesh> meshes;
  for (const Feature& source : all.features) {
    meshes.push_back(triangulated(source, o));
    Feature feature = cut_from(source);
    Rings triangles;
    for (const polygon::Triangle& t : meshes.back().triangles) triangles.push_back(corners(meshes.back(), t));
    feature.polygons = polygons_of(triangles);
    for (Ring& t : triangles) shown.push_back({std::move(t)});
    result.features.push_back(std::move(feature));
  }
  show_pieces(picture, shown);
  for (const Mesh& mesh : meshes) add_vertex_numbers(picture, mesh);
  picture.title = "triangulate, " + o.method + ": " + counted(shown.size(), "triangle");
  PolygonOptions rest = o;
  if (write_meshes(rest, [&] { return flat_mesh(meshes); })) return done;
  write_geometry(rest, inputs.front().format, result, picture);
  return done;
}

int run_strips(const Options& o) {
  const std::vector<PolygonInput> inputs = read_inputs(o);
  note_what_counts_not(inputs);
  const Features all = joined(inputs);
  Picture picture;
  nlohmann::ordered_json features = nlohmann::json::array();
  std::string text;
  std::size_t number = 0, numbers = 0, triangles = 0;
  for (std::size_t i = 0; i < all.features.size(); ++i) {
    const Mesh mesh = triangulated(all.features[i], o);
    const Strips strips = cover_with_strips(mesh.triangles);
    nlohmann::ordered_json j{{"feature", i}, {"vertices", nlohmann::json::array()}, {"strips", strips.strips}};
    for (const Vec2d p : mesh.vertices) j["vertices"].push_back({p.x, p.y});
    features.push_back(j);
    text += describe(all.features[i], i) + ": " + counted(mesh.triangles.size(), "triangle") + " in " +
            counted(strips.strips.size(), "strip") + ", " + std::to_string(strips.vertex_count()) +
            " numbers instead of " + std::to_string(3 * mesh.triangles.size()) + "\n";
    for (const Indices& strip : strips.strips) {
      text += fmt::format("{}\n", fmt::join(strip, " "));
      Ring middles;
      for (const polygon::Triangle& t : triangles_of_strip(strip)) {
        const Ring c = corners(mesh, t);
        picture.areas.push_back({.rings = {c}, .fill = pastel(number), .edge = slate, .edge_width = 1});
        middles.push_back((c[0] + c[1] + c[2]) / 3.0);
      }
      picture.lines.push_back({.points = middles, .colour = strong(number), .arrows = true, .width = 1.6});
      ++number;
    }
    numbers += strips.vertex_count();
    triangles += mesh.triangles.size();
    add_vertex_numbers(picture, mesh);
  }
  picture.title = "strips: " + counted(triangles, "triangle") + " in " + counted(number, "strip") + ", " +
                  std::to_string(numbers) + " numbers";
  write_facts(o, {{"features", features}}, text, picture);
  return done;
}

void add_method(CLI::App& app, Options& o) {
  app.add_option("--method", o.method, "delaunay (constrained), sweep (the fastest) or ears (no holes)")
      ->capture_default_str();
}

}  // namespace

std::function<int()> add_triangulate(CLI::App& app) {
  static Options options;
  add_input_options(app, options);
  add_method(app, options);
  add_geometry_outputs(app, options);
  app.footer("-o may also name a mesh: .ply .obj .glb.");
  return [] { return run_triangulate(options); };
}

std::function<int()> add_strips(CLI::App& app) {
  static Options options;
  add_input_options(app, options);
  add_method(app, options);
  add_fact_outputs(app, options);
  app.footer("Triangle strips that cover a triangulation, as vertex numbers; --json adds the vertices.");
  return [] { return run_strips(options); };
}

}  // namespace lambert::cli
