#include "lambert/polygon/arrangement/marks.h"

#include <algorithm>

namespace lambert::polygon::arrangement {
namespace {

constexpr int most_rounds = 4;

/// Between two marks of an edge, or between one and an end of it.
struct Part {
  Vec2d a, b;
  std::uint32_t edge;
};

/// Marks are sorted along the longer side of an edge's box, where rounding displaces them least.
bool is_steep(Vec2d a, Vec2d b) { return std::abs(b.y - a.y) > std::abs(b.x - a.x); }

class Finder {
 public:
  Finder(const Outline& outline, const BoxTree& tree)
      : outline_(outline), p_(outline.points.data()), tree_(tree), budget_(64 * outline.points.size() + 4096) {}

  bool find_all() {
    const auto pair = [&](std::uint32_t i, std::uint32_t j) { meet_runs(i, j); };
    if (!tree_.visit_pairs(budget_, pair) || work_ > budget_) return false;
    for (int round = 0; !fresh_.empty(); ++round) {
      if (round == most_rounds) return false;
      merge_fresh();
      if (!check_parts(round == 0)) return false;
    }
    return true;
  }

  std::vector<Mark> take() { return std::move(marks_); }

 private:
  std::uint32_t ring_of(std::uint32_t edge) const {
    const auto after = std::upper_bound(outline_.starts.begin(), outline_.starts.end(), edge);
    return static_cast<std::uint32_t>(after - outline_.starts.begin()) - 1;
  }

  /// The vertex at which an edge ends, by the edge that starts there.
  std::uint32_t next(std::uint32_t edge, std::uint32_t ring) const {
    return edge + 2 == outline_.starts[ring + 1] ? outline_.starts[ring] : edge + 1;
  }

  bool is_vertex(const Part& part, Vec2d point) const { return point == p_[part.edge] || point == p_[part.edge + 1]; }

  /// False when the mark is there already.
  bool mark(std::uint32_t edge, std::uint32_t ring, Vec2d point, bool rounded = false) {
    fresh_.push_back({point == p_[edge + 1] ? next(edge, ring) : edge, point, rounded});
    const auto order = [&](const Mark& m, const Mark& n) { return before(m, n); };
    return marks_.empty() || !std::binary_search(marks_.begin(), marks_.end(), fresh_.back(), order);
  }

  void meet_runs(std::uint32_t i, std::uint32_t j) {
    const Run &r = tree_.runs()[i], &s = tree_.runs()[j];
    const Box &b = tree_.box(i), &c = tree_.box(j);
    const Box both{{std::max(b.low.x, c.low.x), std::max(b.low.y, c.low.y)},
                   {std::min(b.high.x, c.high.x), std::min(b.high.y, c.high.y)}};
    work_ += (r.last - r.first) + (s.last - s.first);
    for (std::uint32_t e = r.first; e < r.last; ++e) {
      const Box box = box_of(p_[e], p_[e + 1]);
      if (!box.meets(both)) continue;
      for (std::uint32_t f = s.first; f < s.last; ++f) {
        if (box.meets(box_of(p_[f], p_[f + 1]))) meet({p_[e], p_[e + 1], e}, r.ring, {p_[f], p_[f + 1], f}, s.ring);
      }
    }
  }

  /// Marks where two parts meet, unless they just follow each other along a ring.
  void meet(const Part& s, std::uint32_t s_ring, const Part& t, std::uint32_t t_ring) {
    const int ta = orientation(s.a, s.b, t.a), tb = orientation(s.a, s.b, t.b);
    if (ta * tb > 0) return;
    const int sa = orientation(t.a, t.b, s.a), sb = orientation(t.a, t.b, s.b);
    if (sa * sb > 0) return;
    if (ta * tb < 0 && sa * sb < 0) {
      const Vec2d point = outline_.grid(
          crossing_of_parts({s.a, s.b}, {t.a, t.b}, {p_[s.edge], p_[s.edge + 1]}, {p_[t.edge], p_[t.edge + 1]}));
      const bool rounded = orientation(s.a, s.b, point) != 0 || orientation(t.a, t.b, point) != 0;
      const bool cuts_s = mark(s.edge, s_ring, point, rounded), cuts_t = mark(t.edge, t_ring, point, rounded);
      stuck_ |= !cuts_s && !cuts_t;
      return;
    }
    const bool parallel = ta == 0 && tb == 0;
    if (s_ring == t_ring && !parallel) {
      if (s.b == t.a && s.b == p_[s.edge + 1] && next(s.edge, s_ring) == t.edge) return;
      if (t.b == s.a && t.b == p_[t.edge + 1] && next(t.edge, t_ring) == s.edge) return;
    }
    const auto touch = [&](Vec2d point, int side, const Part& other) {
      if (side != 0 || !in_box({other.a, other.b}, point)) return;
      if ((point == s.a || point == s.b) && (point == t.a || point == t.b) && !is_vertex(s, point) &&
          !is_vertex(t, point))
        return;  // has been marked on both
      const bool cuts_s = mark(s.edge, s_ring, point), cuts_t = mark(t.edge, t_ring, point);
      const bool inside = point != other.a && point != other.b;
      stuck_ |= inside && !(&other == &s ? cuts_s : cuts_t);
    };
    touch(t.a, ta, s);
    touch(t.b, tb, s);
    touch(s.a, sa, t);
    touch(s.b, sb, t);
  }

  bool before(const Mark& m, const Mark& n) const {
    if (m.edge != n.edge) return m.edge < n.edge;
    const Vec2d a = p_[m.edge], b = p_[m.edge + 1];
    const int along_x = m.point.x == n.point.x ? 0 : (m.point.x < n.point.x) == (a.x < b.x) ? -1 : 1;
    const int along_y = m.point.y == n.point.y ? 0 : (m.point.y < n.point.y) == (a.y < b.y) ? -1 : 1;
    return is_steep(a, b) ? along_y < 0 || (along_y == 0 && along_x < 0) : along_x < 0 || (along_x == 0 && along_y < 0);
  }

  /// Sorts the fresh marks in and leaves in fresh_ those that are new.
  void merge_fresh() {
    const auto order = [&](const Mark& m, const Mark& n) { return before(m, n); };
    std::sort(fresh_.begin(), fresh_.end(), order);
    std::size_t kept = 0;
    for (const Mark& m : fresh_) {
      if (kept > 0 && fresh_[kept - 1].edge == m.edge && fresh_[kept - 1].point == m.point) {
        fresh_[kept - 1].rounded |= m.rounded;
      } else {
        fresh_[kept++] = m;
      }
    }
    fresh_.resize(kept);
    if (!marks_.empty()) {
      std::vector<Mark> added;
      std::set_difference(fresh_.begin(), fresh_.end(), marks_.begin(), marks_.end(), std::back_inserter(added), order);
      fresh_ = std::move(added);
    }
    const auto old = static_cast<std::ptrdiff_t>(marks_.size());
    marks_.insert(marks_.end(), fresh_.begin(), fresh_.end());
    std::inplace_merge(marks_.begin(), marks_.begin() + old, marks_.end(), order);
    marked_.resize(outline_.points.size());
    for (const Mark& m : fresh_) {
      if (m.point != p_[m.edge]) marked_[m.edge] = true;
    }
  }

  /// Parts that end in a rounded point may meet what their edges did not. So may, in later rounds, those between exact
  /// ones: they replace others against which the rest has been checked.
  bool check_parts(bool first_round) {
    std::vector<std::uint32_t> edges;
    for (const Mark& m : fresh_) {
      if (m.point != p_[m.edge] && (m.rounded || !first_round) && (edges.empty() || edges.back() != m.edge))
        edges.push_back(m.edge);
    }
    fresh_.clear();
    for (const std::uint32_t edge : edges) {
      for_parts(edge, tree_.whole(), [&](const Part& part) { check_part(part); });
      if (stuck_ || work_ > budget_) return false;
    }
    return true;
  }

  /// Those that may meet the box, at least.
  template <typename Visit>
  void for_parts(std::uint32_t edge, const Box& box, Visit visit) {
    const Vec2d start = p_[edge], end = p_[edge + 1];
    Vec2d a = start;
    if (marked_[edge]) {
      const bool steep = is_steep(start, end), falls = steep ? end.y < start.y : end.x < start.x;
      // Along the axis that marks are sorted by, from where the edge starts.
      const auto way = [&](Vec2d p) { return falls ? -(steep ? p.y : p.x) : (steep ? p.y : p.x); };
      const double enter = std::min(way(box.low), way(box.high)), leave = std::max(way(box.low), way(box.high));
      const auto [first, last] = inner_marks(outline_, marks_, edge);
      const auto begin = marks_.begin();
      const auto from = static_cast<std::size_t>(
          std::partition_point(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last),
                               [&](const Mark& m) { return way(m.point) < enter; }) -
          begin);
      if (from > first) a = marks_[from - 1].point;
      for (std::size_t i = from; i < last; ++i) {
        visit(Part{a, marks_[i].point, edge});
        a = marks_[i].point;
        ++work_;
        if (way(a) > leave) return;
      }
    }
    visit(Part{a, end, edge});
  }

  void check_part(const Part& part) {
    const std::uint32_t ring = ring_of(part.edge);
    const Box box = box_of(part.a, part.b);
    tree_.visit_meeting(box, [&](std::uint32_t i) {
      const Run& run = tree_.runs()[i];
      work_ += run.last - run.first;
      for (std::uint32_t f = run.first; f < run.last; ++f) {
        if (f == part.edge || !box.meets(box_of(p_[f], p_[f + 1]))) continue;
        for_parts(f, box, [&](const Part& other) {
          if (box.meets(box_of(other.a, other.b))) meet(part, ring, other, run.ring);
        });
      }
    });
  }

  const Outline& outline_;
  const Vec2d* p_;
  const BoxTree& tree_;
  std::vector<Mark> marks_, fresh_;
  std::vector<bool> marked_;  // edges with marks inside
  std::size_t work_ = 0, budget_;
  bool stuck_ = false;  // parts of edges still meet in a mark of theirs: rounding has put it out of order
};

}  // namespace

std::pair<std::size_t, std::size_t> inner_marks(const Outline& outline, const std::vector<Mark>& marks,
                                                std::uint32_t edge) {
  const auto lower = [](const Mark& m, std::uint32_t e) { return m.edge < e; };
  auto begin = std::lower_bound(marks.begin(), marks.end(), edge, lower);
  if (begin != marks.end() && begin->edge == edge && begin->point == outline.points[edge]) ++begin;
  const auto end = std::partition_point(begin, marks.end(), [&](const Mark& m) { return m.edge == edge; });
  return {static_cast<std::size_t>(begin - marks.begin()), static_cast<std::size_t>(end - marks.begin())};
}

std::optional<std::vector<Mark>> find_marks(const Outline& outline, const BoxTree& tree) {
  if (tree.expected_pairs() > 24 * static_cast<double>(outline.points.size())) return {};
  Finder finder(outline, tree);
  if (!finder.find_all()) return {};
  return finder.take();
}

}  // namespace lambert::polygon::arrangement
