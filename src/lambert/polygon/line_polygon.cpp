#include "lambert/polygon/line_polygon.h"

#include "lambert/polygon/line_order.h"
#include "lambert/polygon/point_in_polygon.h"
#include "lambert/polygon/predicates.h"
#include "lambert/polygon/scale.h"

#include <algorithm>

namespace lambert::polygon {
namespace {

using Boundary = LineEvent::Boundary;
using Kind = LineEvent::Kind;

/// What changes at a place of the line. Winding numbers are counted in halves: twice the mean of those on both sides of
/// the line. Edges on the line add their direction to the difference of the two.
struct Change {
  LinePlace place;
  int halves = 0, edges = 0, direction = 0;
};

struct State {
  int halves = 0, edges = 0, direction = 0;
  bool inside_left(FillRule rule) const { return is_inside((halves + direction) / 2, rule); }
  bool inside_right(FillRule rule) const { return is_inside((halves - direction) / 2, rule); }
};

class Cut {
 public:
  Cut(Vec2d a, Vec2d b) : a_(a), b_(b), order_(a, b) {}

  void add(const Ring& ring, std::size_t index) {
    const std::size_t n = ring.size();
    sides_.resize(n);
    for (std::size_t i = 0; i < n; ++i) sides_[i] = orientation(a_, b_, ring[i]);
    for (std::size_t i = 0; i < n; ++i) add_edge(ring, i);
    add_events(ring, index);
  }

  LineThrough result(FillRule rule) {
    const auto before = [this](const auto& p, const auto& q) { return order_.compare(p.place, q.place) < 0; };
    std::stable_sort(changes_.begin(), changes_.end(), before);
    std::stable_sort(events_.begin(), events_.end(), before);
    LineThrough through;
    for (const PlacedEvent& e : events_) through.events.push_back(e.event);
    add_pieces(rule, through);
    return through;
  }

 private:
  struct PlacedEvent {
    LinePlace place;
    LineEvent event;
  };

  void add_edge(const Ring& ring, std::size_t i) {
    const std::size_t k = next_index(i, ring.size());
    const int from = sides_[i], to = sides_[k];
    if (from == 0 && to == 0) {
      const LinePlace p{ring[i], ring[i]}, q{ring[k], ring[k]};
      const int order = order_.compare(p, q);
      if (order == 0) return;
      changes_.push_back({order < 0 ? p : q, 0, 1, -order});
      changes_.push_back({order < 0 ? q : p, 0, -1, order});
    } else if (from != to) {
      // Whoever follows the line passes an edge to the left from its left to its right: minus one, or minus a half
      // where only one end is off the line.
      changes_.push_back({place_of(ring, i, k), from - to});
    }
  }

  LinePlace place_of(const Ring& ring, std::size_t i, std::size_t k) const {
    if (sides_[i] == 0) return {ring[i], ring[i]};
    if (sides_[k] == 0) return {ring[k], ring[k]};
    return sides_[i] < 0 ? LinePlace{ring[i], ring[k]} : LinePlace{ring[k], ring[i]};
  }

  void add_event(Kind kind, Boundary boundary, std::size_t ring, std::size_t index, const LinePlace& place) {
    events_.push_back({place, {kind, boundary, ring, index, order_.parameter(place), order_.point(place)}});
  }

  void add_events(const Ring& ring, std::size_t index) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = next_index(i, n);
      if (sides_[i] * sides_[k] < 0) add_event(Kind::crossing, Boundary::crosses, index, i, place_of(ring, i, k));
    }
    if (n == 0) return;
    const auto off = static_cast<std::size_t>(
        std::find_if(sides_.begin(), sides_.end(), [](int side) { return side != 0; }) - sides_.begin());
    if (off == n)
      return add_event(n == 1 ? Kind::vertex : Kind::edges, Boundary::stays_on, index, 0, {ring[0], ring[0]});
    // Each run of vertices on the line, seen from one that is off it.
    int before = 0;
    std::size_t first = n;
    for (std::size_t step = 0; step <= n; ++step) {
      const std::size_t i = (off + step) % n;
      if (sides_[i] == 0) {
        if (first == n) first = i;
        continue;
      }
      if (first != n) {
        const Boundary boundary = before != sides_[i] ? Boundary::crosses
                                  : before > 0        ? Boundary::stays_left
                                                      : Boundary::stays_right;
        const bool single = next_index(first, n) == i;
        add_event(single ? Kind::vertex : Kind::edges, boundary, index, first, {ring[first], ring[first]});
      }
      before = sides_[i], first = n;
    }
  }

  void add_pieces(FillRule rule, LineThrough& through) const {
    State state;
    bool merge_interior = false, merge_edges = false;
    for (std::size_t i = 0; i < changes_.size();) {
      const LinePlace& from = changes_[i].place;
      for (; i < changes_.size() && order_.compare(from, changes_[i].place) == 0; ++i) {
        state.halves += changes_[i].halves, state.edges += changes_[i].edges;
        state.direction += changes_[i].direction;
      }
      if (i == changes_.size()) break;
      const bool on_edge = state.edges > 0, interior = !on_edge && state.inside_left(rule);
      if (interior) extend(through.interior, merge_interior, from, changes_[i].place, true, true);
      if (on_edge)
        extend(through.on_edges, merge_edges, from, changes_[i].place, state.inside_left(rule),
               state.inside_right(rule));
      merge_interior = interior, merge_edges = on_edge;
    }
  }

  void extend(std::vector<LinePiece>& pieces, bool merge, const LinePlace& from, const LinePlace& to, bool inside_left,
              bool inside_right) const {
    if (!merge || pieces.back().inside_left != inside_left || pieces.back().inside_right != inside_right) {
      const double t = order_.parameter(from);
      const Vec2d p = order_.point(from);
      pieces.push_back({t, t, p, p, inside_left, inside_right});
    }
    // Rounding may reverse what is shorter than itself.
    pieces.back().t_to = std::max(pieces.back().t_from, order_.parameter(to));
    pieces.back().to = order_.point(to);
  }

  Vec2d a_, b_;
  LineOrder order_;
  std::vector<int> sides_;
  std::vector<Change> changes_;
  std::vector<PlacedEvent> events_;
};

}  // namespace

LineThrough line_through(const Rings& rings, Vec2d a, Vec2d b, FillRule rule) {
  if (a == b) return {};
  if (const double scale = scale_to_safe(rings, a, b); scale != 1) {
    LineThrough through = line_through(scaled(rings, scale), scale * a, scale * b, rule);
    for (auto* pieces : {&through.interior, &through.on_edges})
      for (LinePiece& p : *pieces) p.from /= scale, p.to /= scale;
    for (LineEvent& e : through.events) e.point /= scale;
    return through;
  }
  Cut cut(a, b);
  for (std::size_t i = 0; i < rings.size(); ++i) cut.add(rings[i], i);
  return cut.result(rule);
}

}  // namespace lambert::polygon
