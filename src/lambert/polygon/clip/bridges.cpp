#include "lambert/polygon/clip/bridges.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace lambert::polygon {
namespace {

/// A directed way from one point of the line to another: along the line, or left of it through some vertices.
struct Arc {
  std::size_t from, to;  ///< nodes: distinct points of the line, in its order
  Ring between;          ///< empty when it runs along the line
};

class Bridges {
 public:
  Bridges(const std::vector<std::vector<SidedVertex>>& clipped, const ClipLine& line) : line_(line) {
    for (const auto& ring : clipped)
      for (const SidedVertex& v : ring)
        if (v.side == 0) nodes_.push_back(v.position);
    const auto before = [&](Vec2d a, Vec2d b) { return line_.compare_along(a, b) < 0; };
    std::sort(nodes_.begin(), nodes_.end(), before);
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    balance_.assign(nodes_.size() + 1, 0);
    for (const auto& ring : clipped) add(ring);
    add_arcs_along_the_line();
  }

  Rings rings() {
    const std::vector<std::size_t> following = join();
    std::vector<bool> done(arcs_.size(), false);
    for (std::size_t start = 0; start < arcs_.size(); ++start) {
      if (done[start]) continue;
      std::vector<std::size_t> way;
      for (std::size_t arc = start; !done[arc]; arc = following[arc]) {
        done[arc] = true;
        way.push_back(arc);
      }
      add_ring(way);
    }
    return std::move(rings_);
  }

 private:
  std::size_t node_of(Vec2d p) const {
    const auto before = [&](Vec2d a, Vec2d b) { return line_.compare_along(a, b) < 0; };
    return static_cast<std::size_t>(std::lower_bound(nodes_.begin(), nodes_.end(), p, before) - nodes_.begin());
  }

  void add(const std::vector<SidedVertex>& ring) {
    const auto on_line = [](const SidedVertex& v) { return v.side == 0; };
    const auto first = static_cast<std::size_t>(std::find_if(ring.begin(), ring.end(), on_line) - ring.begin());
    if (first == ring.size()) {
      Ring untouched;
      for (const SidedVertex& v : ring) untouched.push_back(v.position);
      if (untouched.size() > 2) rings_.push_back(std::move(untouched));
      return;
    }
    const std::size_t first_node = node_of(ring[first].position);
    Arc arc{first_node, first_node, {}};
    for (std::size_t k = 1; k <= ring.size(); ++k) {
      const SidedVertex& v = ring[(first + k) % ring.size()];
      if (v.side != 0) {
        arc.between.push_back(v.position);
        continue;
      }
      arc.to = node_of(v.position);
      const std::size_t to = arc.to;
      if (arc.between.empty())
        count(arc.from, to);
      else
        arcs_.push_back(std::move(arc));
      arc = {to, to, {}};
    }
  }

  /// An edge along the line, as the change of the balance at its ends.
  void count(std::size_t from, std::size_t to) {
    ++balance_[from];
    --balance_[to];
  }

  void add_arcs_along_the_line() {
    long balance = 0;
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      balance += balance_[i];
      for (long n = 0; n < std::abs(balance); ++n) arcs_.push_back(balance > 0 ? Arc{i, i + 1, {}} : Arc{i + 1, i, {}});
    }
  }

  /// An arc's end at a node, known by the direction in which the arc lies from there.
  struct End {
    std::size_t node, arc;
    bool leaves;
    int along;  ///< 1 ahead on the line, 0 left of it, -1 behind
    Vec2d towards;
  };

  End end_of(std::size_t i, bool leaves) const {
    const Arc& arc = arcs_[i];
    const std::size_t node = leaves ? arc.from : arc.to, other = leaves ? arc.to : arc.from;
    if (arc.between.empty()) return {node, i, leaves, other > node ? 1 : -1, nodes_[other]};
    // A neighbour that rounding has put on the wrong side counts as lying on the line.
    const Vec2d towards = leaves ? arc.between.front() : arc.between.back();
    const bool is_left = turn_sign(line_.tail, line_.head, nodes_[node], towards) > 0;
    return {node, i, leaves, is_left ? 0 : line_.compare_along(nodes_[node], towards), towards};
  }

  /// Which arc follows each. By angle from the direction of the line, a piece with its interior on the left shows an
  /// outgoing and then an incoming arc, one with its interior on the right the reverse; pairs nest like brackets.
  std::vector<std::size_t> join() const {
    std::vector<End> ends;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      ends.push_back(end_of(i, true));
      ends.push_back(end_of(i, false));
    }
    std::stable_sort(ends.begin(), ends.end(), [&](const End& a, const End& b) {
      if (a.node != b.node) return a.node < b.node;
      if (a.along != b.along) return a.along > b.along;
      return a.along == 0 && orientation(nodes_[a.node], a.towards, b.towards) > 0;
    });
    std::vector<std::size_t> following(arcs_.size());
    std::vector<const End*> open;
    for (const End& end : ends) {
      if (open.empty() || open.back()->leaves == end.leaves) {
        open.push_back(&end);
        continue;
      }
      following[end.leaves ? open.back()->arc : end.arc] = end.leaves ? end.arc : open.back()->arc;
      open.pop_back();
    }
    return following;
  }

  void add_ring(std::span<const std::size_t> way) {
    Ring ring;
    for (std::size_t k = 0; k < way.size(); ++k) {
      const Arc &arc = arcs_[way[k]], &before = arcs_[way[previous_index(k, way.size())]];
      const bool straight = arc.between.empty() && before.between.empty() &&
                            (arc.to > arc.from) == (before.to > before.from) && way.size() > 1;
      if (!straight) ring.push_back(nodes_[arc.from]);
      ring.insert(ring.end(), arc.between.begin(), arc.between.end());
    }
    if (ring.size() > 2) rings_.push_back(std::move(ring));
  }

  const ClipLine& line_;
  std::vector<Vec2d> nodes_;
  std::vector<long> balance_;
  std::vector<Arc> arcs_;
  Rings rings_;
};

}  // namespace

Rings without_bridges(const std::vector<std::vector<SidedVertex>>& clipped, const ClipLine& line) {
  return Bridges(clipped, line).rings();
}

}  // namespace lambert::polygon
