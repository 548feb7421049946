#include "lambert/polygon/trapezoids.h"

#include "lambert/polygon/no_index.h"
#include "lambert/polygon/predicates.h"
#include "lambert/polygon/scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

namespace lambert::polygon {
namespace {

using Index = std::uint32_t;

/// Lower first, left first where heights are equal.
int compare_yx(Vec2d a, Vec2d b) { return compare_xy({a.y, a.x}, {b.y, b.x}); }

/// A corner of a piece, and which vertex it is if it is one.
struct Corner {
  Vec2d point;
  Index vertex;
};

class Piece {
 public:
  void push(Corner c) {
    if (size_ == 0 || corners_[size_ - 1].point != c.point) corners_[size_++] = c;
  }
  /// Below a local maximum both upper corners are one (E-PG-15).
  std::size_t close() {
    if (size_ > 1 && corners_[0].point == corners_[size_ - 1].point) --size_;
    return size_;
  }
  void clear() { size_ = 0; }
  Corner operator[](std::size_t i) const { return corners_[i]; }

 private:
  std::array<Corner, 4> corners_;
  std::size_t size_ = 0;
};

/// Edge i joins vertex i and its successor.
template <class Sink>
class SlabSweep {
 public:
  SlabSweep(const FlatRings& rings, const Sink& sink)
      : points_(rings.vertices),
        next_(successors(rings)),
        previous_(next_.size()),
        foot_(next_.size()),
        head_(next_.size()),
        cases_(next_.size(), SweepCase::none),
        sink_(sink) {
    for (Index i = 0; i < next_.size(); ++i) previous_[next_[i]] = i;
  }

  std::vector<SweepCase> run() {
    std::vector<Index> order(points_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      const int c = compare_yx(points_[a], points_[b]);
      return c != 0 ? c < 0 : a < b;
    });
    for (auto i = order.begin(); i != order.end();) {
      const double y = points_[*i].y;
      const std::vector<Index> below = active_;
      for (; i != order.end() && points_[*i].y == y;) {
        const auto begin = i;
        while (i != order.end() && points_[*i] == points_[*begin]) ++i;
        visit({begin, i});
      }
      place_corners(below, y);
      for_each_piece(below);
      for (const Index e : active_) foot_[e] = points_[low(e)].y == y ? Corner{points_[low(e)], low(e)} : head_[e];
    }
    return std::move(cases_);
  }

 private:
  Index low(Index edge) const { return compare_yx(points_[edge], points_[next_[edge]]) < 0 ? edge : next_[edge]; }
  Index high(Index edge) const { return compare_yx(points_[edge], points_[next_[edge]]) < 0 ? next_[edge] : edge; }
  bool is_left_edge(std::size_t place) const { return place % 2 == 0; }

  /// The vertices of one place: their edges from below end and those above begin.
  void visit(const std::vector<Index>& vertices) {
    const Vec2d p = points_[vertices[0]];
    std::vector<Index> ending, beginning;
    const auto sort_in = [&](Index edge, Vec2d other) {
      if (const int order = compare_yx(other, p); order != 0) (order < 0 ? ending : beginning).push_back(edge);
    };
    for (const Index v : vertices) sort_in(previous_[v], points_[previous_[v]]), sort_in(v, points_[next_[v]]);

    // The edges through p stand together; others, which may end here only where edges cross, anywhere.
    const auto side = [&](Index e, Vec2d q) { return orientation(points_[low(e)], points_[high(e)], q); };
    auto first = std::partition_point(active_.begin(), active_.end(), [&](Index e) { return side(e, p) < 0; });
    auto last = std::find_if(first, active_.end(), [&](Index e) { return side(e, p) != 0; });
    const auto ends = [&](Index e) { return std::find(ending.begin(), ending.end(), e) != ending.end(); };
    const std::vector<Index> ended_places = places_of(ending);
    std::vector<Index> through;
    std::copy_if(first, last, std::back_inserter(through), [&](Index e) { return !ends(e); });
    const bool all_here = through.size() + ending.size() == static_cast<std::size_t>(last - first);
    through.insert(through.end(), beginning.begin(), beginning.end());
    std::stable_sort(through.begin(), through.end(),
                     [&](Index a, Index b) { return orientation(p, points_[high(a)], points_[high(b)]) < 0; });
    first = active_.erase(first, last);
    active_.insert(first, through.begin(), through.end());
    if (!all_here) std::erase_if(active_, ends);

    for (const Index v : vertices) classify(v, ending, ended_places);
  }

  std::vector<Index> places_of(const std::vector<Index>& edges) const {
    std::vector<Index> places;
    for (const Index e : edges)
      places.push_back(static_cast<Index>(std::find(active_.begin(), active_.end(), e) - active_.begin()));
    return places;
  }

  void classify(Index v, const std::vector<Index>& ending, const std::vector<Index>& ended_places) {
    const Vec2d p = points_[v];
    Index below = 0, above = 0, lowest_place = no_index, highest_place = no_index;
    for (const auto& [edge, other] : {std::pair(previous_[v], previous_[v]), std::pair(v, next_[v])}) {
      const int order = compare_yx(points_[other], p);
      if (order < 0) {
        const auto k = std::find(ending.begin(), ending.end(), edge) - ending.begin();
        lowest_place = std::min(lowest_place, ended_places[static_cast<std::size_t>(k)]);
        ++below;
      } else if (order > 0) {
        const auto k = std::find(active_.begin(), active_.end(), edge) - active_.begin();
        highest_place = std::min(highest_place, static_cast<Index>(k));
        ++above;
      }
    }
    if (below + above < 2) return;
    if (above == 2)
      cases_[v] = is_left_edge(highest_place) ? SweepCase::interior_minimum : SweepCase::exterior_minimum;
    else if (below == 2)
      cases_[v] = is_left_edge(lowest_place) ? SweepCase::interior_maximum : SweepCase::exterior_maximum;
    else
      cases_[v] = is_left_edge(highest_place) ? SweepCase::left_edge : SweepCase::right_edge;
  }

  /// Sets head_ of the edges that reach the line from below. A rounded point is kept between its neighbours on the
  /// line.
  void place_corners(const std::vector<Index>& below, double y) {
    for (const Index e : below) {
      const Vec2d a = points_[low(e)], b = points_[high(e)];
      head_[e] = b.y == y ? Corner{b, high(e)} : Corner{{a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), y}, no_index};
    }
    const auto fixed = [&](Index e) -> const Vec2d* {
      if (points_[high(e)].y == y) return &points_[high(e)];
      return points_[low(e)].y == y ? &points_[low(e)] : nullptr;
    };
    const auto bound = [&](auto begin, auto end, auto clamp) {
      const Vec2d* last = nullptr;
      for (auto e = begin; e != end; ++e) {
        if (const Vec2d* f = fixed(*e)) {
          last = f;
        } else if (last) {
          double& x = head_[*e].point.x;
          x = clamp(x, last->x);
        }
      }
    };
    const auto at_least = [](double x, double limit) { return std::max(x, limit); };
    const auto at_most = [](double x, double limit) { return std::min(x, limit); };
    for (const std::vector<Index>* line : {&below, &std::as_const(active_)}) {
      bound(line->begin(), line->end(), at_least);
      bound(line->rbegin(), line->rend(), at_most);
    }
    const Vec2d* last = nullptr;
    for (const Index e : below) {
      if (last && !fixed(e)) head_[e].point.x = std::max(head_[e].point.x, last->x);
      last = &head_[e].point;
    }
  }

  /// The slab between foot_ and head_, by the cases of the notes: one step for each point of the lower line (E-PG-12).
  /// Cases 5 and 6 have no edge above them and give no step; the sides of the notes' box B* are where the loop ends.
  void for_each_piece(const std::vector<Index>& edges) {
    Piece piece;
    const auto output = [&] {
      if (const std::size_t size = piece.close(); size >= 3) sink_(piece, size);
      piece.clear();
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Corner point = foot_[edges[i]], up = head_[edges[i]];
      const bool minimum =
          i + 1 < edges.size() && point.vertex != no_index && foot_[edges[i + 1]].vertex == point.vertex;
      if (is_left_edge(i) && !minimum) {  // case 1
        piece.push(up), piece.push(point);
      } else if (!minimum) {  // case 2
        piece.push(point), piece.push(up);
        output();
      } else if (is_left_edge(i)) {  // case 3
        const Corner right_up = head_[edges[++i]];
        piece.push(point), piece.push(right_up), piece.push(up);
        output();
      } else {  // case 4
        const Corner right_up = head_[edges[++i]];
        piece.push(point), piece.push(up);
        output();
        piece.push(right_up), piece.push(point);  // the notch itself (E-PG-11)
      }
    }
  }

  const std::vector<Vec2d>& points_;
  std::vector<Index> next_, previous_;
  std::vector<Index> active_;        // edges that cross the line, from left to right; left and right ones alternate
  std::vector<Corner> foot_, head_;  // of each edge in a slab: its points on the lower and the upper line
  std::vector<SweepCase> cases_;
  const Sink& sink_;
};

bool heights_differ(const std::vector<Vec2d>& points) {
  std::vector<double> y;
  for (const Vec2d p : points) y.push_back(p.y);
  std::sort(y.begin(), y.end());
  return std::adjacent_find(y.begin(), y.end()) == y.end();
}

}  // namespace

std::vector<SweepCase> trapezoids(const FlatRings& rings, const std::function<void(const Trapezoid&)>& sink,
                                  TrapezoidOptions options) {
  if (const double scale = safe_scale(sizes_of(rings.vertices)); scale != 1)
    return trapezoids(
        scaled(rings, scale),
        [&](Trapezoid t) {
          for (Vec2d& corner : t.corners) corner /= scale;
          sink(t);
        },
        options);
  const auto hand_on = [&](const Piece& piece, std::size_t size, const auto& place) {
    Trapezoid t{.size = size};
    for (std::size_t i = 0; i < size; ++i) t.corners[i] = place(piece[i]);
    sink(t);
  };
  if (options.tie_break == TieBreak::symbolic || rings.vertices.empty()) {
    const auto emit = [&](const Piece& piece, std::size_t size) {
      hand_on(piece, size, [](const Corner& c) { return c.point; });
    };
    return SlabSweep(rings, emit).run();
  }

  std::mt19937_64 random(options.seed);
  const Vec2d centre = rings.vertices[0];
  FlatRings turned = rings;
  double c = 1, s = 0;
  // Vertices in one place are of one height at any angle.
  constexpr int tries = 16;
  for (int i = 0; i < tries; ++i) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(random() >> 11) * 0x1p-53);
    c = std::cos(angle), s = std::sin(angle);
    for (std::size_t k = 0; k < turned.vertices.size(); ++k) {
      const Vec2d d = rings.vertices[k] - centre;
      turned.vertices[k] = {c * d.x - s * d.y, s * d.x + c * d.y};
    }
    if (heights_differ(turned.vertices)) break;
  }
  const auto emit = [&](const Piece& piece, std::size_t size) {
    hand_on(piece, size, [&](const Corner& corner) {
      const Vec2d p = corner.point;
      return corner.vertex == no_index ? centre + Vec2d(c * p.x + s * p.y, c * p.y - s * p.x)
                                       : rings.vertices[corner.vertex];
    });
  };
  return SlabSweep(turned, emit).run();
}

Trapezoids trapezoids(const Region& region, TrapezoidOptions options) {
  Trapezoids all;
  all.cases = trapezoids(
      flat(region), [&](const Trapezoid& t) { all.pieces.push_back(t); }, options);
  return all;
}

}  // namespace lambert::polygon
