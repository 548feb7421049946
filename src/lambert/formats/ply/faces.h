#pragma once
/// The faces of a PLY file: polygons of any size, and triangle strips.

#include "lambert/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lambert::ply {

/// Collects faces as they come. Polygons wait for finish(), since the vertices may stand behind the faces.
class FaceList {
 public:
  explicit FaceList(std::size_t vertex_count) : vertex_count_(vertex_count) {}
  bool is_valid(std::int64_t index) const { return index >= 0 && static_cast<std::uint64_t>(index) < vertex_count_; }
  std::vector<Triangle>& triangles() { return triangles_; }
  /// Fewer than three corners make no face.
  void add_polygon(std::span<const std::uint32_t> face);
  /// Each corner makes a triangle with the two before it; no_corner starts anew.
  void add_strip(std::span<const std::uint32_t> strip);
  static constexpr std::uint32_t no_corner = ~std::uint32_t{0};
  void finish(TriangleMesh& mesh);

 private:
  std::size_t vertex_count_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> corners_;  // of polygons with more than three
  std::vector<std::size_t> sizes_;
};

}  // namespace lambert::ply
