#include "lambert/polygon/triangulate.h"

#include "lambert/polygon/interval_tree.h"
#include "lambert/polygon/predicates.h"
#include "lambert/polygon/scale.h"
#include "lambert/polygon/sorted_points.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace lambert::polygon {
namespace {

using Index = std::uint32_t;
using Side = IntervalTree::Side;

/// Edge i joins vertex i and its successor.
class Sweep {
 public:
  /// The rings must outlive it.
  explicit Sweep(const FlatRings& rings)
      : points_(rings.vertices),
        next_(successors(rings)),
        previous_(next_.size()),
        left_(next_.size()),
        right_(next_.size()),
        owner_(next_.size(), no_index) {
    for (Index i = 0; i < next_.size(); ++i) {
      previous_[next_[i]] = i;
      const bool rightwards = compare_xy(points_[i], points_[next_[i]]) < 0;
      left_[i] = rightwards ? i : next_[i];
      right_[i] = rightwards ? next_[i] : i;
    }
    triangles_.reserve(points_.size());
    nodes_.reserve(points_.size() + points_.size() / 2);
  }

  std::vector<Triangle> run() {
    const std::vector<Index> order = sorted_left_to_right(points_);
    for (auto i = order.begin(); i != order.end();) {
      const auto begin = i;
      while (i != order.end() && points_[*i] == points_[*begin]) ++i;
      if (i == begin + 1 && (trimmed_.empty() || !trimmed_.count(*begin)))
        visit(*begin);
      else
        visit_together({begin, i});
    }
    return std::move(triangles_);
  }

 private:
  /// A vertex of a chain, which runs from the lower edge of an interval to the upper one.
  struct Node {
    Vec2d point;
    Index vertex, below, above;
  };
  /// The interior between two edges that cross the sweep line. Its chain turns nowhere towards the interior, which lies
  /// right of it, and goes right up to `last` and left from there: no triangle fits behind it.
  struct Interval {
    Index lower, upper;      // edges
    Index first, last, end;  // nodes: left end of the lower edge, the last one visited, left end of the upper edge
  };

  Vec2d left_of(Index edge) const { return points_[left_[edge]]; }
  Vec2d right_of(Index edge) const { return points_[right_[edge]]; }

  void visit(Index v) {
    const Index in = previous_[v], out = v;
    if (in == out) return;
    const bool in_arrives = right_[in] == v, out_arrives = right_[out] == v;
    if (in_arrives != out_arrives) return pass(v, in_arrives ? in : out, in_arrives ? out : in);
    const int turn = orientation(points_[in], points_[v], points_[next_[v]]);
    if (turn == 0) return visit_together({v});
    if (in_arrives)
      close(v, turn > 0 ? in : out, turn > 0 ? out : in);
    else
      open(v, turn > 0 ? out : in, turn > 0 ? in : out);
  }

  /// Vertices in one place: which of their edges were paired does not matter, and any pairs that do not cross give the
  /// same interior.
  void visit_together(const std::vector<Index>& vertices) {
    const Index v = vertices[0];
    const Vec2d p = points_[v];
    std::vector<Index> lefts, rights;
    for (const Index at : vertices) {
      for (const auto& [edge, other] : {std::pair(previous_[at], previous_[at]), std::pair(at, next_[at])}) {
        const int order = compare_xy(points_[other], p);
        if (order > 0) rights.push_back(edge);
        if (order < 0 && owner_[edge] != no_index) lefts.push_back(edge);
      }
      const auto [first, last] = trimmed_.equal_range(at);
      for (auto it = first; it != last; ++it) rights.push_back(it->second);
      trimmed_.erase(first, last);
    }
    std::sort(lefts.begin(), lefts.end(), [&](Index a, Index b) { return orientation(left_of(a), p, left_of(b)) > 0; });
    std::sort(rights.begin(), rights.end(), [&](Index a, Index b) {
      const int turn = orientation(p, right_of(a), right_of(b));
      return turn != 0 ? turn > 0 : compare_xy(right_of(a), right_of(b)) < 0;
    });
    drop_coincident(rights, p);
    close_coincident(v, lefts);
    std::size_t i = 0, k = 0;
    for (; i + 1 < lefts.size(); i += 2) close(v, lefts[i], lefts[i + 1]);
    if (i < lefts.size() && k < rights.size()) pass(v, lefts[i], rights[k++]);
    for (; k + 1 < rights.size(); k += 2) open(v, rights[k], rights[k + 1]);
  }

  /// Two edges enclose nothing as far as they coincide: of each pair that leaves p in one direction only what the
  /// longer one has beyond the shorter is kept, for later. The longest go first, so that no rest lies on an edge that
  /// stays.
  void drop_coincident(std::vector<Index>& rights, Vec2d p) {
    for (std::size_t k = rights.size(); k-- > 1;) {
      const Index shorter = rights[k - 1], longer = rights[k];
      if (orientation(p, right_of(shorter), right_of(longer)) != 0) continue;
      if (right_of(shorter) != right_of(longer)) {
        left_[longer] = right_[shorter];
        trimmed_.emplace(right_[shorter], longer);
      }
      const auto first = rights.begin() + static_cast<std::ptrdiff_t>(k - 1);
      rights.erase(first, first + 2);
      if (--k == 0) break;
    }
  }

  /// Of edges that arrive in one direction, whose order is not known, closes pairs with the interior on opposite sides.
  void close_coincident(Index v, std::vector<Index>& lefts) {
    const auto is_lower = [&](Index edge) { return intervals_[owner_[edge]].lower == edge; };
    for (std::size_t k = 0; k + 1 < lefts.size();) {
      const Index a = lefts[k], b = lefts[k + 1];
      if (orientation(left_of(a), points_[v], left_of(b)) == 0 && is_lower(a) != is_lower(b)) {
        close(v, a, b);
        lefts.erase(lefts.begin() + static_cast<std::ptrdiff_t>(k), lefts.begin() + static_cast<std::ptrdiff_t>(k + 2));
        k -= std::min<std::size_t>(k, 1);
      } else {
        ++k;
      }
    }
  }

  /// One edge takes over from the other.
  void pass(Index v, Index left, Index right) {
    const Index i = owner_[left];
    if (i == no_index) return;
    if (intervals_[i].lower == left) {
      serve_from_below(i, v);
      intervals_[i].lower = right;
    } else {
      serve_from_above(i, v);
      intervals_[i].upper = right;
    }
    owner_[right] = i;
  }

  /// Two edges begin: a new interval, or a new exterior that splits one.
  void open(Index v, Index lower, Index upper) {
    const Vec2d p = points_[v], q[] = {right_of(lower), right_of(upper)};
    const auto side = [&](Index edge) {
      const Vec2d a = left_of(edge), b = right_of(edge);
      if (const int o = orientation(a, b, p)) return o;
      if (const int o = orientation(a, b, q[0])) return o;
      return orientation(a, b, q[1]);
    };
    const auto place = tree_.find([&](Index i) {
      if (side(intervals_[i].lower) < 0) return Side::before;
      return side(intervals_[i].upper) > 0 ? Side::after : Side::here;
    });
    const Index fresh = new_interval();
    Interval& added = intervals_[fresh];
    if (place.item == no_index || place.side != Side::here) {
      const Index n = new_node(v, no_index, no_index);
      added = {lower, upper, n, n, n};
      owner_[lower] = owner_[upper] = fresh;
      return tree_.insert(place, fresh);
    }
    Interval& split = intervals_[place.item];
    const Node last = nodes_[split.last];
    const Index twin = new_node(last.vertex, no_index, last.above);
    if (last.above != no_index) nodes_[last.above].below = twin;
    nodes_[split.last].above = no_index;
    added = {upper, split.upper, twin, twin, last.above == no_index ? twin : split.end};
    split.upper = lower, split.end = split.last;
    owner_[upper] = owner_[added.upper] = fresh;
    owner_[lower] = place.item;
    tree_.insert_after(place.item, fresh);
    serve_from_above(place.item, v);
    serve_from_below(fresh, v);
  }

  /// Two edges end: an interval does, or the exterior between two.
  void close(Index v, Index lower, Index upper) {
    const Index a = owner_[lower], b = owner_[upper];
    if (a == no_index || b == no_index) return;
    if (a == b) {
      serve_from_below(a, v);
      return remove(a);
    }
    if (intervals_[a].upper == lower && intervals_[b].lower == upper) return join(v, a, b);
    if (intervals_[a].lower == lower && intervals_[b].upper == upper) return join(v, b, a);
    // Only where edges cross: any interval will do that keeps the two edges that go on.
    const auto other = [&](Index i, Index edge) {
      return intervals_[i].lower == edge ? intervals_[i].upper : intervals_[i].lower;
    };
    const Index n = new_node(v, no_index, no_index);
    intervals_[a] = {other(a, lower), other(b, upper), n, n, n};
    owner_[intervals_[a].upper] = a;
    remove(b);
  }

  void join(Index v, Index below, Index above) {
    serve_from_above(below, v);
    serve_from_below(above, v);
    Interval &a = intervals_[below], &b = intervals_[above];
    const Index rest = nodes_[b.first].above;
    a.last = a.end;
    nodes_[a.end].above = rest;
    if (rest != no_index) {
      nodes_[rest].below = a.end;
      a.end = b.end;
    }
    a.upper = b.upper;
    owner_[a.upper] = below;
    remove(above);
  }

  /// v ends the lower edge: cuts off what it sees of the chain, from its lower end, and becomes that end.
  void serve_from_below(Index interval, Index v) {
    Interval& i = intervals_[interval];
    const Vec2d p = points_[v];
    Index at = i.first;
    for (Index beyond; (beyond = nodes_[at].above) != no_index; at = beyond) {
      const Node &a = nodes_[at], &b = nodes_[beyond];
      const int turn = orientation(a.point, p, b.point);
      if (turn > 0) triangles_.push_back({a.vertex, v, b.vertex});
      // A chain that comes back on itself has no area to cut off.
      if (turn < 0 || (turn == 0 && compare_xy(a.point, b.point) > 0)) break;
    }
    nodes_[at].below = no_index;
    if (nodes_[at].point != p) {
      const Index n = new_node(v, no_index, at);
      nodes_[at].below = n;
      at = n;
    }
    i.first = i.last = at;
  }

  void serve_from_above(Index interval, Index v) {
    Interval& i = intervals_[interval];
    const Vec2d p = points_[v];
    Index at = i.end;
    for (Index beyond; (beyond = nodes_[at].below) != no_index; at = beyond) {
      const Node &a = nodes_[at], &b = nodes_[beyond];
      const int turn = orientation(b.point, p, a.point);
      if (turn > 0) triangles_.push_back({b.vertex, v, a.vertex});
      if (turn < 0 || (turn == 0 && compare_xy(a.point, b.point) > 0)) break;
    }
    nodes_[at].above = no_index;
    if (nodes_[at].point != p) {
      const Index n = new_node(v, at, no_index);
      nodes_[at].above = n;
      at = n;
    }
    i.end = i.last = at;
  }

  Index new_node(Index v, Index below, Index above) {
    nodes_.push_back({points_[v], v, below, above});
    return static_cast<Index>(nodes_.size() - 1);
  }
  Index new_interval() {
    if (free_.empty()) {
      intervals_.emplace_back();
      return static_cast<Index>(intervals_.size() - 1);
    }
    const Index i = free_.back();
    free_.pop_back();
    return i;
  }
  void remove(Index interval) {
    tree_.remove(interval);
    free_.push_back(interval);
  }

  const std::vector<Vec2d>& points_;
  std::vector<Index> next_, previous_;
  std::vector<Index> left_, right_;      // ends of each edge
  std::multimap<Index, Index> trimmed_;  // edges that begin at a vertex only because what comes before was dropped
  std::vector<Index> owner_;             // of each edge that crosses the sweep line: its interval
  std::vector<Node> nodes_;
  std::vector<Interval> intervals_;
  std::vector<Index> free_;
  IntervalTree tree_;
  std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> triangulate(const FlatRings& rings) {
  const double scale = safe_scale(sizes_of(rings.vertices));
  return scale == 1 ? Sweep(rings).run() : Sweep(scaled(rings, scale)).run();
}
std::vector<Triangle> triangulate(const Rings& rings) { return triangulate(flat(rings)); }
std::vector<Triangle> triangulate(const Region& region) { return triangulate(flat(region)); }

}  // namespace lambert::polygon
