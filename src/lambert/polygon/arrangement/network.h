#pragma once
/// The ways between the marks of an outline, and what lies on their sides.

#include "lambert/polygon/arrangement/boundary.h"
#include "lambert/polygon/arrangement/marks.h"

#include <vector>

namespace lambert::polygon::arrangement {

/// A part of a ring from node to node, with no node between.
struct Way {
  std::uint32_t from, to;    ///< nodes
  std::uint32_t begin, end;  ///< the vertices between, in the outline
  std::uint64_t start;       ///< where on the outline: the edge, times 2^32, and how many marks inside it come before
  Winding delta{};           ///< left less right; zero when it bounds nothing or has merged into `same`
  Winding right{};
  std::uint32_t same = none;  ///< the way along the same edge that stands for this one too
};

/// Built once, then asked for boundaries of sets.
class Network {
 public:
  /// `marks` as find_marks gives them. O(n + k log k), and for each connected part a search in the tree for what lies
  /// below.
  Network(const Outline& outline, const BoxTree& tree, const Marks& marks);

  Regions select(const Selection& selection) const;

 private:
  struct Spoke {
    std::uint32_t way;
    bool leaves;
  };
  struct DirectedSpoke {
    Vec2d towards;
    Spoke spoke;
    bool is_left;  // smaller than the node
  };
  struct Below {
    std::uint32_t way = none;
    bool leftwards = false;  // the way runs from right to left there
  };

  std::uint32_t node_at(Vec2d p);
  void make_ways();
  void add_way(std::uint32_t from, std::uint32_t to, std::uint32_t begin, std::uint32_t end, std::uint64_t start);
  void make_spokes();
  void sort_spokes(std::uint32_t node);
  void merge_same();
  void wind();
  void wind_from(std::uint32_t way);
  void wind_around(std::uint32_t node);
  Vec2d direction(Spoke spoke) const;
  Winding left(const Way& way) const { return way.right + way.delta; }
  template <typename Accept>
  Below way_below(Vec2d v, Accept accept) const;
  std::uint32_t way_of(std::uint32_t edge, std::size_t marks_before) const;

  const Outline& outline_;
  const BoxTree& tree_;
  const Marks& marks_;
  std::vector<Vec2d> nodes_;
  std::vector<std::uint32_t> table_;  // nodes by the hash of their point, open addressing
  std::vector<Way> ways_;
  std::vector<std::uint32_t> spoke_start_;
  std::vector<Spoke> spokes_;
  std::vector<DirectedSpoke> directed_;   // of the node at hand
  std::vector<bool> wound_, node_wound_;  // ways and nodes whose windings are known
  std::vector<std::uint32_t> open_;       // ways whose ends are yet to be looked at
};

}  // namespace lambert::polygon::arrangement
