#pragma once
/// A tree of boxes over short monotone parts of rings: finds what lies near what, fast for outlines that are coherent,
/// as nearly all are. It gives no guarantee; users count its work and turn to the sweep when it is too much.

#include "lambert/polygon/arrangement/outline.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace lambert::polygon::arrangement {

struct Box {
  Vec2d low, high;

  bool meets(const Box& o) const {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
};

inline Box box_of(Vec2d a, Vec2d b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

inline Box common_part(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

/// Edges first, first + 1, ..., last - 1 of one ring, monotone in x and in y: they do not meet each other but in shared
/// vertices, and their box is that of the first and the last point.
struct Run {
  std::uint32_t first, last, ring;
  bool apart;  ///< follows the run before it in the tree, and meets it in the common vertex alone
};

/// The boxes of four siblings, side by side for vector instructions; missing ones meet nothing.
struct FourBoxes {
  static constexpr double far = std::numeric_limits<double>::infinity();
  double low_x[4] = {far, far, far, far}, low_y[4] = {far, far, far, far};
  double high_x[4] = {-far, -far, -far, -far}, high_y[4] = {-far, -far, -far, -far};

  Box box(std::uint32_t i) const { return {{low_x[i], low_y[i]}, {high_x[i], high_y[i]}}; }
  void set(std::uint32_t i, const Box& box) {
    low_x[i] = box.low.x;
    low_y[i] = box.low.y;
    high_x[i] = box.high.x;
    high_y[i] = box.high.y;
  }
  Box hull() const;

  /// Bit i tells whether box i meets the given one.
  unsigned meeting(const Box& b) const {
    // Vectors of GCC and Clang; the loop over four comparisons does not become one by itself.
    using Doubles [[gnu::vector_size(32)]] = double;
    using Bits [[gnu::vector_size(32)]] = std::int64_t;
    const auto load = [](const double* from) {
      Doubles all;
      std::memcpy(&all, from, sizeof all);
      return all;
    };
    const Bits hit = (load(low_x) <= b.high.x) & (load(high_x) >= b.low.x) & (load(low_y) <= b.high.y) &
                     (load(high_y) >= b.low.y) & Bits{1, 2, 4, 8};
    return static_cast<unsigned>((hit[0] | hit[1]) | (hit[2] | hit[3]));
  }
};

class BoxTree {
 public:
  /// Of an outline that is not empty.
  explicit BoxTree(const Outline& outline);

  const std::vector<Run>& runs() const { return runs_; }
  Box box(std::uint32_t run) const { return levels_.front()[run / 4].box(run % 4); }
  const Box& whole() const { return whole_; }

  /// How many pairs of runs would have meeting boxes if they lay about at random.
  double expected_pairs() const;

  struct Pair {
    std::uint32_t i, j;
  };

  /// All pairs of runs i < j whose boxes meet, but those that are just `apart`; false when that would be more
  /// than `most` pairs or take more than four times so many comparisons of four boxes with one.
  bool find_pairs(std::size_t most, std::vector<Pair>& pairs) const;

  /// Calls visit(run) for the runs whose box reaches the vertical at or below `p`, as long as they reach above the
  /// height that the last visit returned; upper boxes first.
  template <typename Visit>
  void visit_below(Vec2d p, Visit visit) const;

 private:
  std::vector<Run> runs_;
  std::vector<std::vector<FourBoxes>> levels_;  // each a quarter as long as the one before; the last has one entry
  Box whole_{};
};

template <typename Visit>
void BoxTree::visit_below(Vec2d p, Visit visit) const {
  struct Node {
    std::uint32_t level, index;
    double top;
  };
  Node stack[64];
  std::size_t depth = 0;
  double above = whole_.low.y;
  const auto push_children = [&](std::size_t level, std::uint32_t index) {
    const FourBoxes& boxes = levels_[level][index];
    const std::size_t begin = depth;
    for (unsigned hit = boxes.meeting({{p.x, above}, p}); hit != 0; hit &= hit - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(hit));
      Node node{static_cast<std::uint32_t>(level), 4 * index + i, boxes.high_y[i]};
      std::size_t at = depth++;
      for (; at > begin && stack[at - 1].top > node.top; --at) stack[at] = stack[at - 1];
      stack[at] = node;
    }
  };
  push_children(levels_.size() - 1, 0);
  while (depth > 0) {
    const Node node = stack[--depth];
    if (node.top < above) continue;
    if (node.level == 0) {
      above = visit(node.index);
    } else {
      push_children(node.level - 1, node.index);
    }
  }
}

}  // namespace lambert::polygon::arrangement
