#include "lambert/polygon/line_through.h"

#include "lambert/polygon/line_order.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lambert::polygon {
namespace {

/// With its coordinates, rounded.
struct Place {
  LinePlace on_line;
  Vec2d point;
  bool is_vertex() const { return on_line.is_vertex(); }
};

/// What the winding numbers just left and just right of the line gain in passing.
struct Passing {
  Place place;
  int left, right;
};

struct Found {
  Place place;  ///< of the end that comes first
  LineEvent event;
};

class Walk {
 public:
  Walk(const Rings& rings, const ClipLine& line) : line_(line), order_(line.tail, line.head) {
    for (std::size_t r = 0; r < rings.size(); ++r) add_ring(rings[r], r);
    const auto by_place = [&](const auto& a, const auto& b) { return compare(a.place, b.place) < 0; };
    std::stable_sort(passings_.begin(), passings_.end(), by_place);
    std::stable_sort(events_.begin(), events_.end(), by_place);
  }

  LineThrough result(FillRule rule) const {
    LineThrough through;
    for (const Found& found : events_) through.events.push_back(found.event);
    const auto inside = [&](int winding) { return rule == FillRule::even_odd ? winding % 2 != 0 : winding != 0; };
    int left = 0, right = 0;
    LineState state = LineState::outside;
    Vec2d point(0);
    for (std::size_t first = 0, end = 0; first < passings_.size(); first = end) {
      const Place* place = &passings_[first].place;
      for (end = first + 1; end < passings_.size() && compare(*place, passings_[end].place) == 0; ++end)
        if (better_known(passings_[end].place, *place)) place = &passings_[end].place;
      // Places that rounding has put out of order meet in one point.
      if (first == 0 || line_.compare_along(point, place->point) < 0) {
        extend(through, state, point, place->point);
        point = place->point;
      }
      const LineState before = state;
      for (std::size_t i = first; i < end; ++i) {
        left += passings_[i].left;
        right += passings_[i].right;
      }
      state = inside(left) ? (inside(right) ? LineState::inside : LineState::edge_interior_left)
                           : (inside(right) ? LineState::edge_interior_right : LineState::outside);
      if (place->is_vertex() && state == before) through.touches.push_back({place->point, state});
    }
    return through;
  }

  bool touches_vertex() const {
    return std::any_of(passings_.begin(), passings_.end(), [](const Passing& p) { return p.place.is_vertex(); });
  }

  std::vector<Vec2d> points() const {
    std::vector<Vec2d> points;
    for (const Passing& passing : passings_) points.push_back(passing.place.point);
    return points;
  }

 private:
  static void extend(LineThrough& through, LineState state, Vec2d from, Vec2d to) {
    if (state == LineState::outside) return;
    auto& pieces = state == LineState::inside ? through.inside : through.edges;
    if (!pieces.empty() && pieces.back().to == from && pieces.back().state == state)
      pieces.back().to = to;
    else
      pieces.push_back({from, to, state});
  }

  /// Of places that are the same point: a vertex has no rounding; of two roundings the choice is the same for any
  /// order.
  static bool better_known(const Place& a, const Place& b) {
    if (a.is_vertex() != b.is_vertex()) return a.is_vertex();
    return compare_xy(a.point, b.point) < 0;
  }

  static Place vertex(Vec2d p) { return {{p, p}, p}; }

  int compare(const Place& a, const Place& b) const { return order_.compare(a.on_line, b.on_line); }

  void add_crossing(const Ring& ring, std::size_t r, std::size_t i, int side) {
    const Vec2d a = ring[i], b = ring[next_index(i, ring.size())], point = line_.crossing(a, b);
    const Place place{side > 0 ? LinePlace{.right = b, .left = a} : LinePlace{.right = a, .left = b}, point};
    passings_.push_back({place, side, side});
    events_.push_back({place, {LineEventKind::edge_crossing, LineContext::crosses, r, i, point, point}});
  }

  /// `count` vertices on the line from `first`; the boundary comes from one side and leaves to another. Coming from the
  /// left of the line to it winds once more around what lies ahead on the left, leaving to the left once less.
  void add_run(const Ring& ring, std::size_t r, std::size_t first, std::size_t count, int from_side, int to_side) {
    const Vec2d from = ring[first], to = ring[(first + count - 1) % ring.size()];
    bool is_point = true;
    for (std::size_t k = 1; k < count; ++k) is_point = is_point && ring[(first + k) % ring.size()] == from;
    passings_.push_back({vertex(from), from_side > 0 ? 1 : 0, from_side < 0 ? -1 : 0});
    passings_.push_back({vertex(to), to_side > 0 ? -1 : 0, to_side < 0 ? 1 : 0});
    const LineContext context = from_side == 0         ? LineContext::within
                                : from_side != to_side ? LineContext::crosses
                                : from_side > 0        ? LineContext::minimum
                                                       : LineContext::maximum;
    events_.push_back({vertex(line_.compare_along(from, to) <= 0 ? from : to),
                       {is_point ? LineEventKind::vertex : LineEventKind::edge_on_line, context, r, first, from, to}});
  }

  void add_ring(const Ring& ring, std::size_t r) {
    const std::size_t n = ring.size();
    std::vector<int> sides;
    for (const Vec2d p : ring) sides.push_back(line_.side(p));
    const auto start = static_cast<std::size_t>(
        std::find_if(sides.begin(), sides.end(), [](int side) { return side != 0; }) - sides.begin());
    if (start == n) {
      if (n > 0) add_run(ring, r, 0, n, 0, 0);
      return;
    }
    for (std::size_t k = 0; k < n;) {
      const std::size_t i = (start + k) % n;
      std::size_t run = 0;
      while (sides[(i + 1 + run) % n] == 0) ++run;
      const int next = sides[(i + 1 + run) % n];
      if (run > 0)
        add_run(ring, r, next_index(i, n), run, sides[i], next);
      else if (sides[i] != next)
        add_crossing(ring, r, i, sides[i]);
      k += run + 1;
    }
  }

  ClipLine line_;
  LineOrder order_;
  std::vector<Passing> passings_;
  std::vector<Found> events_;
};

}  // namespace

LineThrough line_through(const Rings& rings, Vec2d tail, Vec2d head, FillRule rule) {
  if (tail == head) return {};
  return Walk(rings, {tail, head}).result(rule);
}

std::optional<std::vector<std::pair<Vec2d, Vec2d>>> alternating_pairs(const Rings& rings, Vec2d tail, Vec2d head) {
  std::vector<std::pair<Vec2d, Vec2d>> pairs;
  if (tail == head) return pairs;
  const Walk walk(rings, {tail, head});
  if (walk.touches_vertex()) return std::nullopt;
  const std::vector<Vec2d> points = walk.points();
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) pairs.emplace_back(points[i], points[i + 1]);
  return pairs;
}

}  // namespace lambert::polygon
