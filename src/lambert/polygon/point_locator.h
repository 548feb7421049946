#pragma once
#include "lambert/polygon/edge_list.h"
#include "lambert/polygon/locator_strips.h"

#include <cstdint>
#include <vector>

namespace lambert::polygon {

/// Rings prepared for many questions where a point lies: a grid of cells, each with its edges and the winding number of
/// one point of it. A question counts the edges between that point and its own; where no edge comes near, it reads one
/// number. Cells that many edges pass are divided once more, into strips along these edges.
///
/// The answers are those of winding_around() and locate(), all of them. Building takes O(n log n) and memory O(n):
/// cells are as small as a fixed number of cells and of entries per edge allow. A question takes about constant time
/// where edges are short or run side by side, O(n) at worst.
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
  Box2 box() const { return {box_.min / scale_, box_.max / scale_}; }

 private:
  struct Cell {
    std::uint32_t first, last;  ///< its edges in listed_; of divided cells `first` is their number in strips_
    std::int32_t winding;       ///< at references_, or one of the two below
  };
  static constexpr std::int32_t unknown = LocatorStrips::unknown, divided = unknown + 1;
  struct Range {
    std::uint32_t first, last;
  };

  void choose_grid();
  void list_edges();
  void find_windings();
  void divide_crowded_cells();
  std::uint32_t column(double x) const;
  std::uint32_t row(double y) const;
  Range columns_in_row(std::uint32_t edge, std::uint32_t r) const;
  Vec2d candidate(std::uint32_t cell, int k) const;
  Winding winding_of_all(Vec2d p) const;

  Winding winding_of_scaled(Vec2d p) const;

  double scale_;  ///< of all that follows
  Box2 box_;
  EdgeList edges_;
  std::uint32_t columns_ = 1, rows_ = 1;
  Vec2d cell_size_{0}, per_cell_{0}, slack_{0};
  std::vector<Cell> cells_;            ///< row by row
  std::vector<std::uint32_t> listed_;  ///< edges, cell by cell
  std::vector<Vec2d> references_;      ///< of each cell: a point on no edge
  LocatorStrips strips_;
};

}  // namespace lambert::polygon
