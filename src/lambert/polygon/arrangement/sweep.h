#pragma once
/// One pass of the sweep line over pieces.

#include "lambert/polygon/arrangement/subdivision.h"

#include <vector>

namespace lambert::polygon::arrangement {

/// Moves over pieces, splits what meets, merges what coincides.
class Sweep {
 public:
  Sweep(const Outline& outline, std::vector<Piece>& pieces) : outline_(outline), pieces_(pieces) {}

  /// Afterwards either the pieces are a proper subdivision with windings, supports and nodes, or the result is false:
  /// something was moved by rounding, and another pass is needed. With a tolerance above 0, pieces also go through ends
  /// of others within that part of their largest coordinate, and no crossing is made so near to an end. Crossings lie
  /// on `grid`.
  bool run(const Grid& grid, double tolerance);
  std::uint32_t node_count() const { return nodes_; }

 private:
  /// A point to come at which pieces have been cut: two of them end there, and two start.
  struct Event {
    Vec2d point;
    std::uint32_t ends[2], starts[2];  ///< slots and pieces
  };
  struct Cut {
    std::uint32_t piece;
    Vec2d point;
  };

  void sort_ends();
  bool next_point();
  void handle_point();
  void collect();
  void collect_end(std::uint32_t slot);
  void find_neighbours();
  void absorb_touching();
  double reach(Vec2d a, Vec2d b, Vec2d c) const;
  bool touches_point(const Piece& piece);
  Vec2d snap_to_end(Vec2d q, Segment s, Segment t) const;
  std::uint32_t cut_off(std::uint32_t piece, Vec2d p);
  void cut_at_point(std::uint32_t piece);
  void order_starting();
  void insert_starting();
  void check(std::uint32_t low, std::uint32_t high);
  void cut_crossing(std::uint32_t low, std::uint32_t high);
  void cut(std::uint32_t piece, Event& event, int which);
  void push(const Event& event);
  void finish();

  const Outline& outline_;
  Grid grid_;
  double tolerance_ = 0;
  std::vector<Piece>& pieces_;
  Status status_;
  std::vector<std::uint32_t> place_, slot_;  // of each piece; the slot is where its right end is kept
  std::vector<std::uint32_t> order_;         // the pieces at the start, by their left ends
  std::vector<std::uint32_t> owner_;         // of each slot, the piece that ends there; the first slots sorted by point
  std::size_t next_in_order_ = 0, next_slot_ = 0, sorted_slots_ = 0;
  std::vector<Event> events_;                   // a heap
  std::vector<std::uint32_t> started_, ended_;  // in the order of the sweep, for the next pass
  std::vector<Cut> late_cuts_;                  // for the next pass
  bool moved_ = false;
  std::uint32_t nodes_ = 0;

  // Of the point at hand.
  Vec2d point_{0, 0};
  std::vector<std::uint32_t> starting_, ending_;
  std::uint32_t below_ = none, above_ = none;  // places
};

}  // namespace lambert::polygon::arrangement
