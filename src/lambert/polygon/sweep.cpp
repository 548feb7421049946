#include "lambert/polygon/sweep.h"

#include "lambert/polygon/crossing_order.h"
#include "lambert/polygon/ordered_list.h"
#include "lambert/polygon/scale.h"

#include <algorithm>
#include <numeric>

namespace lambert::polygon {
namespace {

using Index = std::uint32_t;
using Node = OrderedList::Node;
using Edge = SweepSegments::Edge;

constexpr Index none = ~Index{0};

enum class Role : std::uint8_t { ending, starting, point };

struct End {
  Vec2d point;
  Index segment;
  Role role;
};

/// The segments that cross the sweep line, from below, and what is known of their crossings to come.
class Sweep {
 public:
  Sweep(const SweepSegments& segments, SweepVisitor& visitor);
  void run();

 private:
  const Edge& edge(Node n) const { return segments_.edges[status_[n]]; }
  /// On which side of the segment at n the point lies: 1 above.
  int side(Node n, Vec2d p) const { return orientation(edge(n).left, edge(n).right, p); }
  void read_event(Index event);
  bool settle_crossings(Index event);
  bool visit_point(Index event);
  void collect_through(Index event);
  void erase(Index segment);
  void look_for_crossing(Node below, Node above, Index earliest);
  Index event_after_crossing(Index s, Index t, Index earliest) const;

  const SweepSegments& segments_;
  SweepVisitor& visitor_;
  std::vector<End> ends_;
  std::vector<Index> first_end_;    ///< of each event, and one more
  std::vector<Index> right_event_;  ///< of each segment
  OrderedList status_;
  std::vector<Node> node_;  ///< of each segment; OrderedList::end while it is not in the status
  struct Pair {
    Index below, above, next;
  };
  std::vector<Pair> pairs_;
  std::vector<Index>
      first_pair_;  ///< of each event: pairs that were neighbours and cross before it, after the one before
  std::vector<Index> ending_, through_, starting_, points_, group_;
};

Sweep::Sweep(const SweepSegments& segments, SweepVisitor& visitor)
    : segments_(segments),
      visitor_(visitor),
      right_event_(segments.edges.size(), none),
      node_(segments.edges.size(), OrderedList::end) {
  ends_.reserve(2 * segments.edges.size());
  for (Index s = 0; s < segments.edges.size(); ++s) {
    const Edge& e = segments.edges[s];
    if (e.left == e.right) {
      ends_.push_back({e.left, s, Role::point});
    } else {
      ends_.push_back({e.left, s, Role::starting});
      ends_.push_back({e.right, s, Role::ending});
    }
  }
  std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) { return compare_xy(a.point, b.point) < 0; });
  for (Index i = 0; i < ends_.size(); ++i) {
    if (i == 0 || ends_[i].point != ends_[i - 1].point) first_end_.push_back(i);
    if (ends_[i].role == Role::ending) right_event_[ends_[i].segment] = static_cast<Index>(first_end_.size() - 1);
  }
  first_pair_.assign(first_end_.size(), none);
  first_end_.push_back(static_cast<Index>(ends_.size()));
}

void Sweep::run() {
  for (Index event = 0; event + 1 < first_end_.size(); ++event)
    if (!settle_crossings(event) || !visit_point(event)) return;
}

/// The first event that the crossing of s and t precedes; none when it is the point of an event. It lies before the
/// right ends of both and not before the event `earliest - 1`.
Index Sweep::event_after_crossing(Index s, Index t, Index earliest) const {
  const Edge &a = segments_.edges[s], &b = segments_.edges[t];
  Index low = earliest, high = std::max(earliest, std::min(right_event_[s], right_event_[t]));
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    const int order = compare_crossing(a.left, a.right, b.left, b.right, ends_[first_end_[middle]].point);
    if (order == 0) return none;
    (order < 0 ? high : low) = order < 0 ? middle : middle + 1;
  }
  return low;
}

/// Of two neighbours, which do not meet before the event `earliest` unless they cross after the one before it.
void Sweep::look_for_crossing(Node below, Node above, Index earliest) {
  if (below == OrderedList::end || above == OrderedList::end) return;
  const Index s = status_[below], t = status_[above];
  if (segments_.rank[s] <= segments_.rank[t]) return;
  // They cross if whichever ends first does so on the far side of the other.
  const Vec2d s_end = segments_.edges[s].right, t_end = segments_.edges[t].right;
  const int order = compare_xy(s_end, t_end);
  const bool cross = order < 0 ? side(above, s_end) > 0 : order > 0 && side(below, t_end) < 0;
  if (!cross) return;
  const Index event = event_after_crossing(s, t, earliest);
  if (event == none) return;
  pairs_.push_back({s, t, first_pair_[event]});
  first_pair_[event] = static_cast<Index>(pairs_.size() - 1);
}

bool Sweep::settle_crossings(Index event) {
  while (first_pair_[event] != none) {
    const auto [s, t, next] = pairs_[first_pair_[event]];
    first_pair_[event] = next;
    const Node below = node_[s], above = node_[t];
    if (below == OrderedList::end || above == OrderedList::end || status_.next(below) != above) continue;
    if (!visitor_.crossing(s, t)) return false;
    status_.set(below, t), status_.set(above, s);
    node_[t] = below, node_[s] = above;
    look_for_crossing(status_.previous(below), below, event);
    look_for_crossing(above, status_.next(above), event);
  }
  return true;
}

void Sweep::read_event(Index event) {
  ending_.clear(), starting_.clear(), points_.clear(), through_.clear();
  for (Index i = first_end_[event]; i < first_end_[event + 1]; ++i) {
    const Index s = ends_[i].segment;
    switch (ends_[i].role) {
      case Role::ending: ending_.push_back(s); break;
      case Role::starting: starting_.push_back(s); break;
      case Role::point: points_.push_back(s); break;
    }
  }
}

void Sweep::erase(Index segment) {
  if (node_[segment] == OrderedList::end) return;
  status_.erase(node_[segment]);
  node_[segment] = OrderedList::end;
}

bool Sweep::visit_point(Index event) {
  read_event(event);
  const Vec2d p = ends_[first_end_[event]].point;
  // The segments that contain p are neighbours: [first, above).
  Node first, above;
  if (!ending_.empty() && node_[ending_[0]] != OrderedList::end) {
    first = node_[ending_[0]], above = status_.next(first);
    for (Node n = status_.previous(first); n != OrderedList::end && side(n, p) == 0; n = status_.previous(n)) first = n;
  } else {
    first = status_.partition_point(
        [&](Index s) { return orientation(segments_.edges[s].left, segments_.edges[s].right, p) > 0; });
    above = first;
  }
  while (above != OrderedList::end && side(above, p) == 0) above = status_.next(above);
  const Node below = status_.previous(first);
  for (Node n = first; n != above; n = status_.next(n))
    if (right_event_[status_[n]] != event) through_.push_back(status_[n]);

  if (!visitor_.at_point({p, ending_, through_, starting_, points_})) return false;

  // Beyond p they lie in the order of their slopes. Nodes are used again where there are any.
  group_ = through_;
  group_.insert(group_.end(), starting_.begin(), starting_.end());
  if (group_.size() > 1)
    std::stable_sort(group_.begin(), group_.end(),
                     [&](Index s, Index t) { return segments_.rank[s] < segments_.rank[t]; });
  std::size_t used = 0;
  for (Node place = first; place != above;) {
    const Node following = status_.next(place);
    if (const Index old = status_[place]; node_[old] == place) node_[old] = OrderedList::end;
    if (used < group_.size()) {
      status_.set(place, group_[used]);
      node_[group_[used++]] = place;
    } else {
      status_.erase(place);
    }
    place = following;
  }
  for (; used < group_.size(); ++used) node_[group_[used]] = status_.insert_before(above, group_[used]);

  if (group_.empty()) {
    look_for_crossing(below, above, event + 1);
  } else {
    look_for_crossing(below, node_[group_.front()], event + 1);
    look_for_crossing(node_[group_.back()], above, event + 1);
  }
  // None is left here unless the predicates were beyond their range.
  for (const Index s : ending_) erase(s);
  return true;
}

/// A slope in double, off by at most two units: infinite for vertical segments.
double rounded_slope(const Edge& e) { return (e.right.y - e.left.y) / (e.right.x - e.left.x); }

void rank_by_slope(SweepSegments& segments) {
  const std::vector<Edge>& edges = segments.edges;
  struct Slope {
    double slope;
    Index segment;
  };
  std::vector<Slope> order;
  order.reserve(edges.size());
  for (Index s = 0; s < edges.size(); ++s)
    if (!segments.is_point(s)) order.push_back({rounded_slope(edges[s]), s});
  std::sort(order.begin(), order.end(), [](const Slope& a, const Slope& b) { return a.slope < b.slope; });
  const auto turn = [&](const Slope& a, const Slope& b) {
    const Edge &s = edges[a.segment], &t = edges[b.segment];
    return turn_sign(s.left, s.right, t.left, t.right);
  };
  // Rounded slopes decide unless they are within some units of each other.
  const auto close = [](double a, double b) { return !(b - a > 0x1p-48 * (std::abs(a) + std::abs(b)) + 0x1p-1070); };
  for (auto first = order.begin(); first != order.end();) {
    auto last = first + 1;
    while (last != order.end() && close((last - 1)->slope, last->slope)) ++last;
    // Merging, unlike partitioning, stays within its bounds even when the predicates are beyond their range.
    if (last - first > 1) std::stable_sort(first, last, [&](const Slope& a, const Slope& b) { return turn(a, b) > 0; });
    first = last;
  }
  Index current = 0;
  segments.by_slope.reserve(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && turn(order[i - 1], order[i]) != 0) ++current;
    segments.rank[order[i].segment] = current;
    segments.by_slope.push_back(order[i].segment);
  }
}

}  // namespace

SweepSegments prepare_sweep(std::span<const Segment> segments) {
  SweepSegments prepared;
  Sizes sizes;
  for (const Segment& s : segments) sizes.add(s.a), sizes.add(s.b);
  prepared.scale = safe_scale(sizes);
  prepared.edges.reserve(segments.size());
  for (const Segment& s : segments) {
    const Vec2d a = prepared.scale * s.a, b = prepared.scale * s.b;
    prepared.edges.push_back(compare_xy(a, b) <= 0 ? Edge{a, b} : Edge{b, a});
  }
  prepared.rank.assign(segments.size(), 0);
  rank_by_slope(prepared);
  return prepared;
}

void sweep(const SweepSegments& segments, SweepVisitor& visitor) { Sweep(segments, visitor).run(); }

}  // namespace lambert::polygon
