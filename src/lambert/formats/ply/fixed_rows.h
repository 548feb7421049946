#pragma once
/// Binary rows that all have the same size are read in parallel, without walking from one to the next.

#include "lambert/formats/ply/faces.h"
#include "lambert/formats/ply/header.h"
#include "lambert/formats/ply/vertices.h"

#include <optional>
#include <string>

namespace lambert::ply {

/// `e` must have no lists.
void read_fixed_vertices(const char* rows, const Element& e, bool swap, const VertexLayout& layout, TriangleMesh& mesh);

/// Where in a row of triangles its corners stand, if every row has the same size in bytes.
struct TriangleRows {
  std::size_t count_offset = 0, corner_offset = 0, stride = 0;
  Type count_type = Type::uint8, corner_type = Type::int32;
};
/// None when the rows are not all triangles or have other lists.
std::optional<TriangleRows> triangle_rows(const Element& e, const char* rows, std::size_t bytes, bool swap);
/// Throws Error naming the first face whose index is out of range.
void read_fixed_triangles(const TriangleRows& layout, const char* rows, std::size_t count, bool swap,
                          const std::string& name, FaceList& faces);

}  // namespace lambert::ply
