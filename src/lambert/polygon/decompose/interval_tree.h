#pragma once
#include "lambert/polygon/decompose/no_index.h"

#include <cstdint>
#include <vector>

namespace lambert::polygon {

/// A sequence of small numbers, each at most once, that is searched from a root: a treap (Seidel and Aragon, 1996)
/// whose priorities are a fixed hash of the number, so that the same calls always give the same tree. Height is
/// logarithmic on average; insertion and removal are O(1) on average once the place is known.
class IntervalTree {
 public:
  enum class Side : std::uint8_t { before, here, after };

  struct Place {
    std::uint32_t item = no_index;  ///< the one sought, or the last one met on the way
    Side side = Side::here;         ///< on which side of it the search left the tree; `here` when found or empty
  };

  /// `side_of(item)` says where what is sought lies, seen from the item.
  template <class SideOf>
  Place find(const SideOf& side_of) const {
    Place place;
    for (std::uint32_t at = root_; at != no_index;) {
      place = {at, side_of(at)};
      if (place.side == Side::here) break;
      at = place.side == Side::before ? links_[at].left : links_[at].right;
    }
    return place;
  }

  /// Puts the item where find() ended without finding.
  void insert(Place place, std::uint32_t item);
  void insert_after(std::uint32_t neighbour, std::uint32_t item);
  void remove(std::uint32_t item);

 private:
  struct Links {
    std::uint32_t left = no_index, right = no_index, parent = no_index, priority = 0;
  };

  void attach(std::uint32_t parent, bool right, std::uint32_t item);
  void rotate_up(std::uint32_t child);
  void replace(std::uint32_t child, std::uint32_t by);

  std::uint32_t root_ = no_index;
  std::vector<Links> links_;
};

}  // namespace lambert::polygon
