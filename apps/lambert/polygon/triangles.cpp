#include "triangles.h"
#include "places.h"

#include "lambert/base/error.h"
#include "lambert/polygon/boolean/boolean.h"
#include "lambert/polygon/decompose/delaunay.h"
#include "lambert/polygon/decompose/ear_clipping.h"
#include "lambert/polygon/decompose/triangulate.h"

#include <CLI/CLI.hpp>

namespace lambert::cli {

using namespace polygon;
using namespace draw;

namespace {

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

}  // namespace

void add_method(CLI::App& app, TriangulateOptions& o) {
  app.add_option("--method", o.method, "delaunay (constrained), sweep (the fastest) or ears (no holes)")
      ->capture_default_str();
}

FeatureTriangles triangulated(const Feature& feature, const TriangulateOptions& o) {
  const Regions regions = normalised(rings_of(feature), fill_rule(o));
  const Rings rings = rings_of(regions);
  const FlatRings numbered = flat(rings);
  if (o.method == "delaunay") return {rings, numbered.vertices, delaunay(numbered)};
  if (o.method == "sweep") return {rings, numbered.vertices, triangulate(numbered)};
  if (o.method == "ears") return {rings, numbered.vertices, ears_of(regions)};
  throw Error("--method: unknown method " + unknown_word(o.method, {"delaunay", "sweep", "ears"}));
}

Ring corners(const FeatureTriangles& mesh, const polygon::Triangle& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

void add_vertex_numbers(Picture& picture, const FeatureTriangles& mesh) {
  std::size_t first = 0;
  for (const Ring& ring : mesh.rings) {
    add_indices(picture, {ring}, ink, first);
    first += ring.size();
  }
}

}  // namespace lambert::cli
