#pragma once
/// One pass of the sweep line over pieces.

#include "lambert/polygon/arrangement/subdivision.h"

#include <vector>

namespace lambert::polygon::arrangement {

/// Moves over `pieces`, splits what meets, merges what coincides. Afterwards either the pieces are a proper subdivision
/// with windings, supports and nodes, or the result is false: something was moved by rounding, and another pass is
/// needed.
class Sweep {
 public:
  Sweep(const Outline& outline, double tolerance, std::vector<Piece>& pieces)
      : outline_(outline), tolerance_(tolerance), pieces_(pieces) {}

  bool run();
  std::uint32_t node_count() const { return nodes_; }

 private:
  struct Event {
    Vec2d point;
    std::uint32_t piece;
  };
  struct Cut {
    std::uint32_t piece;
    Vec2d point;
  };

  bool next_point();
  void handle_point();
  void collect_ending();
  void collect_starting();
  void find_neighbours();
  void absorb_touching();
  bool touches_point(const Piece& piece);
  void cut_at_point(std::uint32_t piece);
  void order_starting();
  void insert_starting();
  void check(std::uint32_t low, std::uint32_t high);
  void cut_crossing(std::uint32_t low, std::uint32_t high);
  void cut(std::uint32_t piece, Vec2d p);
  void add_later(Vec2d a, Vec2d b, std::uint32_t line, Winding delta);
  void push(std::vector<Event>& heap, Vec2d point, std::uint32_t piece);
  Event pop(std::vector<Event>& heap);
  void finish();

  const Outline& outline_;
  double tolerance_;
  std::vector<Piece>& pieces_;
  Status status_;
  std::vector<std::uint32_t> place_;  // of each piece
  std::vector<std::uint32_t> order_;  // the pieces at the start, by their left ends
  std::size_t next_in_order_ = 0;
  std::vector<Event> ends_, starts_;  // heaps
  std::vector<Cut> late_cuts_;        // for the next pass
  bool moved_ = false;
  std::uint32_t nodes_ = 0;

  // Of the point at hand.
  Vec2d point_{0, 0};
  std::vector<std::uint32_t> starting_, ending_;
  std::uint32_t below_ = none, above_ = none;  // places
};

}  // namespace lambert::polygon::arrangement
