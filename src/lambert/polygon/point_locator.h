#pragma once
#include "lambert/polygon/point_in_polygon.h"

#include <cstdint>
#include <vector>

namespace lambert::polygon {

/// Rings prepared for many questions where a point lies: a grid of cells, each with its edges and the winding number of
/// one point of it. A question counts the edges between that point and its own; where no edge comes near, it reads one
/// number.
///
/// The answers are those of locate(), all of them. Building takes O(n log n) and memory O(n): cells are as small as
/// some edges to a cell and a fixed number of cells per edge allow. A question takes about constant time for outlines
/// whose edges are short, O(n) at worst.
class PointLocator {
 public:
  explicit PointLocator(const Rings& rings);

  /// As winding_around().
  Winding winding(Vec2d p) const;
  Place locate(Vec2d p, FillRule rule = FillRule::even_odd) const {
    const Winding w = winding(p);
    if (w.on) return Place::on;
    return is_inside(w.number, rule) ? Place::inside : Place::outside;
  }
  const Box2& box() const { return box_; }

 private:
  struct Cell {
    std::uint32_t first;  ///< of its edges in edges_; they end where those of the next cell begin
    std::int32_t winding;
  };
  struct Range {
    std::uint32_t first, last;
  };

  void choose_grid();
  void list_edges();
  void find_windings();
  std::uint32_t column(double x) const;
  std::uint32_t row(double y) const;
  Range columns_in_row(std::uint32_t edge, std::uint32_t r) const;
  Vec2d candidate(std::uint32_t cell, int k) const;
  Winding winding_from(Vec2d reference, int winding, Vec2d p, const std::uint32_t* first,
                       const std::uint32_t* last) const;
  Winding winding_of_all(Vec2d p) const;

  Box2 box_;
  std::vector<Vec2d> points_;          ///< of all rings, each with its first vertex repeated
  std::vector<std::uint32_t> starts_;  ///< edge k runs from points_[starts_[k]] to the next
  std::uint32_t columns_ = 1, rows_ = 1;
  Vec2d cell_size_{0}, per_cell_{0}, slack_{0};
  std::vector<Cell> cells_;           ///< row by row, and one more
  std::vector<std::uint32_t> edges_;  ///< starts, cell by cell
  std::vector<Vec2d> references_;     ///< of each cell: where its winding number holds
};

}  // namespace lambert::polygon
