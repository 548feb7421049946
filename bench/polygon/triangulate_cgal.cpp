#include "triangulate_cgal.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <utility>
#include <vector>

namespace lambert::bench {

std::size_t cgal_triangle_count(const polygon::FlatRings& rings) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_2<Kernel>;
  using Face =
      CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
  using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

  std::vector<Kernel::Point_2> points;
  points.reserve(rings.vertices.size());
  for (const Vec2d p : rings.vertices) points.emplace_back(p.x, p.y);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  edges.reserve(points.size());
  const auto next = polygon::successors(rings);
  for (std::size_t i = 0; i < next.size(); ++i) edges.emplace_back(i, next[i]);
  Delaunay triangulation;
  triangulation.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());

  // Depth of nesting, from the outside inwards.
  for (const auto face : triangulation.all_face_handles()) face->info() = -1;
  std::vector<Delaunay::Face_handle> level = {triangulation.infinite_face()}, next_level;
  std::size_t inside = 0;
  for (int depth = 0; !level.empty(); ++depth, level.swap(next_level), next_level.clear()) {
    while (!level.empty()) {
      const Delaunay::Face_handle face = level.back();
      level.pop_back();
      if (face->info() != -1) continue;
      face->info() = depth;
      inside += static_cast<std::size_t>(depth % 2);
      for (int i = 0; i < 3; ++i)
        if (face->neighbor(i)->info() == -1)
          (face->is_constrained(i) ? next_level : level).push_back(face->neighbor(i));
    }
  }
  return inside;
}

}  // namespace lambert::bench
