#pragma once
/// A tree of boxes over short monotone parts of rings: finds what lies near what, fast for outlines that are coherent,
/// as nearly all are. It gives no guarantee; users count its work and turn to the sweep when it is too much.

#include "lambert/polygon/arrangement/outline.h"

#include <algorithm>
#include <cstdint>
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

/// Edges first, first + 1, ..., last - 1 of one ring, monotone in x and in y: they do not meet each other but in shared
/// vertices, and their box is that of the first and the last point.
struct Run {
  std::uint32_t first, last, ring;
  bool continues;  ///< the run before, without turning back in x or y
};

class BoxTree {
 public:
  explicit BoxTree(const Outline& outline);

  const std::vector<Run>& runs() const { return runs_; }
  const Box& box(std::uint32_t run) const { return boxes_[run]; }
  const Box& whole() const { return boxes_.back(); }

  /// How many pairs of runs would have meeting boxes if they lay about at random.
  double expected_pairs() const;

  /// Calls visit(i, j) for all runs i < j whose boxes meet, but those that just continue each other. Returns false when
  /// more than `budget` pairs of boxes had to be compared, without having visited all.
  template <typename Visit>
  bool visit_pairs(std::size_t budget, Visit visit) const;

  /// Calls visit(run) for all runs whose box meets the given one.
  template <typename Visit>
  void visit_meeting(const Box& box, Visit visit) const;

  /// Calls visit(run) for runs whose box reaches the vertical below `p`, upper ones first where it is easy, as long as
  /// they reach above the height that the last visit returned.
  template <typename Visit>
  void visit_below(Vec2d p, Visit visit) const;

 private:
  struct Node {
    std::uint32_t level, index;
  };

  std::uint32_t at(std::uint32_t level, std::uint32_t index) const { return level_start_[level] + index; }
  std::uint32_t size(std::uint32_t level) const { return level_start_[level + 1] - level_start_[level]; }
  std::uint32_t top() const { return static_cast<std::uint32_t>(level_start_.size()) - 2; }

  std::vector<Run> runs_;
  std::vector<Box> boxes_;                  // level after level, each half as long as the one before
  std::vector<std::uint32_t> level_start_;  // and the end
};

template <typename Visit>
bool BoxTree::visit_pairs(std::size_t budget, Visit visit) const {
  struct Pair {
    std::uint32_t level, i, j;
  };
  std::vector<Pair> stack;
  std::size_t compared = 0;
  for (std::uint32_t level = 0; level < top(); ++level) {
    const std::uint32_t count = size(level);
    for (std::uint32_t i = 0; i + 1 < count; i += 2) {
      stack.push_back({level, i, i + 1});
      while (!stack.empty()) {
        const Pair pair = stack.back();
        stack.pop_back();
        ++compared;
        if (!boxes_[at(pair.level, pair.i)].meets(boxes_[at(pair.level, pair.j)])) continue;
        if (pair.level == 0) {
          if (pair.j != pair.i + 1 || !runs_[pair.j].continues) visit(pair.i, pair.j);
          continue;
        }
        const std::uint32_t below = pair.level - 1, end = size(below);
        for (std::uint32_t a = 2 * pair.i; a < std::min(2 * pair.i + 2, end); ++a) {
          for (std::uint32_t b = 2 * pair.j; b < std::min(2 * pair.j + 2, end); ++b) stack.push_back({below, a, b});
        }
      }
      if (compared > budget) return false;
    }
  }
  return true;
}

template <typename Visit>
void BoxTree::visit_meeting(const Box& box, Visit visit) const {
  if (runs_.empty()) return;
  Node stack[64];
  std::size_t depth = 0;
  stack[depth++] = {top(), 0};
  while (depth > 0) {
    const Node node = stack[--depth];
    if (!boxes_[at(node.level, node.index)].meets(box)) continue;
    if (node.level == 0) {
      visit(node.index);
      continue;
    }
    const std::uint32_t child = 2 * node.index;
    if (child + 1 < size(node.level - 1)) stack[depth++] = {node.level - 1, child + 1};
    stack[depth++] = {node.level - 1, child};
  }
}

template <typename Visit>
void BoxTree::visit_below(Vec2d p, Visit visit) const {
  if (runs_.empty()) return;
  Node stack[64];
  std::size_t depth = 0;
  double above = whole().low.y;
  stack[depth++] = {top(), 0};
  while (depth > 0) {
    const Node node = stack[--depth];
    const Box& box = boxes_[at(node.level, node.index)];
    if (p.x < box.low.x || box.high.x < p.x || p.y < box.low.y || box.high.y < above) continue;
    if (node.level == 0) {
      above = visit(node.index);
      continue;
    }
    std::uint32_t first = 2 * node.index, second = first + 1;
    if (second < size(node.level - 1)) {
      if (boxes_[at(node.level - 1, first)].high.y < boxes_[at(node.level - 1, second)].high.y)
        std::swap(first, second);
      stack[depth++] = {node.level - 1, second};
    }
    stack[depth++] = {node.level - 1, first};
  }
}

}  // namespace lambert::polygon::arrangement
