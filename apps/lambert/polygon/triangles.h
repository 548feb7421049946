#pragma once
/// The triangles of a feature, which `triangulate` writes and `strips` covers.

#include "verb.h"

#include "lambert/polygon/decompose/triangle.h"

namespace lambert::cli {

struct TriangulateOptions : PolygonOptions {
  std::string method = "delaunay";
};
/// --method
void add_method(CLI::App& app, TriangulateOptions& o);

/// The triangles of one feature and the vertices that they number.
struct FeatureTriangles {
  polygon::Rings rings;
  std::vector<Vec2d> vertices;
  std::vector<polygon::Triangle> triangles;
};
/// Of what its rings enclose. Throws Error for an unknown method, or one that does not take holes where there are some.
FeatureTriangles triangulated(const polygon::Feature& feature, const TriangulateOptions& o);

polygon::Ring corners(const FeatureTriangles& mesh, const polygon::Triangle& t);
void add_vertex_numbers(draw::Picture& picture, const FeatureTriangles& mesh);

}  // namespace lambert::cli
