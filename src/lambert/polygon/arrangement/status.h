#pragma once
/// The pieces that a sweep line meets, from below to above.

#include <cstdint>
#include <vector>

namespace lambert::polygon::arrangement {

constexpr std::uint32_t none = 0xffffffff;

/// A treap over items, threaded into a list: neighbours in O(1), insertion above a known item and removal in O(1)
/// expected rotations, search in O(log n) expected. Deterministic: priorities come from a fixed sequence.
class Status {
 public:
  using Place = std::uint32_t;

  void clear() {
    nodes_.clear();
    free_.clear();
    root_ = lowest_ = none;
    state_ = 0x9e3779b97f4a7c15;
  }

  std::uint32_t& item(Place place) { return nodes_[place].item; }
  Place above(Place place) const { return nodes_[place].above; }
  Place below(Place place) const { return nodes_[place].below; }
  Place lowest() const { return lowest_; }

  /// The highest place whose item `is_below` holds for, or none; it must hold for a lower part of the items.
  template <typename IsBelow>
  Place last_below(IsBelow is_below) const {
    Place found = none;
    for (Place at = root_; at != none;) {
      const bool lower = is_below(nodes_[at].item);
      if (lower) found = at;
      at = lower ? nodes_[at].right : nodes_[at].left;
    }
    return found;
  }

  /// Puts an item right above `place`, or lowest of all when that is none.
  Place insert_above(Place place, std::uint32_t item);
  void erase(Place place);

 private:
  struct Node {
    std::uint32_t item, priority;
    Place parent, left, right, below, above;
  };

  void rotate_up(Place place);
  void replace_child(Place parent, Place old_child, Place child);

  std::vector<Node> nodes_;
  std::vector<Place> free_;
  Place root_ = none, lowest_ = none;
  std::uint64_t state_ = 0x9e3779b97f4a7c15;
};

}  // namespace lambert::polygon::arrangement
