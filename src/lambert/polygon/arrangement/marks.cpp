#include "lambert/polygon/arrangement/marks.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace lambert::polygon::arrangement {
namespace {

constexpr int most_rounds = 4;

/// Pairs of runs to look at, for each edge; the sweep is faster than more. They are hardly fewer than expected of boxes
/// that lie about at random, and often more.
constexpr double most_pairs = 8, most_expected = 4;

/// Between two marks of an edge, or between one and an end of it.
struct Part {
  Vec2d a, b;
  std::uint32_t edge, run;
};

/// Marks are sorted along the longer side of an edge's box, where rounding displaces them least.
bool is_steep(Vec2d a, Vec2d b) { return std::abs(b.y - a.y) > std::abs(b.x - a.x); }

class Finder {
 public:
  Finder(const Outline& outline, const BoxTree& tree, double most)
      : outline_(outline),
        p_(outline.points.data()),
        tree_(tree),
        runs_(tree.runs().data()),
        changed_(tree.runs().size()),
        most_pairs_(static_cast<std::size_t>(most)),
        budget_(8 * most_pairs_ + 4096) {}

  bool find_all() {
    pairs_.reserve(tree_.runs().size());
    if (!tree_.find_pairs(most_pairs_, pairs_)) return false;
    marks_.inside.resize(outline_.points.size());
    for (const BoxTree::Pair pair : pairs_) meet_runs(pair);
    for (int round = 0; !fresh_.empty(); ++round) {
      if (round == most_rounds) return false;
      merge_fresh(round == 0);
      check_parts();
      if (stuck_ || work_ > budget_) return false;
    }
    return true;
  }

  Marks take() { return std::move(marks_); }

 private:
  /// The vertex at which an edge ends, by the edge that starts there.
  std::uint32_t next(std::uint32_t edge, std::uint32_t run) const {
    const std::uint32_t ring = runs_[run].ring;
    return edge + 2 == outline_.starts[ring + 1] ? outline_.starts[ring] : edge + 1;
  }

  /// False when it does not cut the edge: it is there already, or at an end of it.
  bool mark(const Part& part, Vec2d point, bool rounded) {
    const std::uint32_t edge = point == p_[part.edge + 1] ? next(part.edge, part.run) : part.edge;
    fresh_.push_back({edge, rounded, point});
    fresh_run_.push_back(part.run);
    const auto order = [&](const Mark& m, const Mark& n) { return before(m, n); };
    return !is_vertex(part, point) && !std::binary_search(marks_.all.begin(), marks_.all.end(), fresh_.back(), order);
  }

  bool is_vertex(const Part& part, Vec2d point) const { return point == p_[part.edge] || point == p_[part.edge + 1]; }

  void meet_runs(BoxTree::Pair pair) {
    const Run &r = runs_[pair.i], &s = runs_[pair.j];
    const Box both = common_part(tree_.box(pair.i), tree_.box(pair.j));
    for (std::uint32_t e = r.first; e < r.last; ++e) {
      const Box box = box_of(p_[e], p_[e + 1]);
      if (!box.meets(both)) continue;
      for (std::uint32_t f = s.first; f < s.last; ++f) {
        if (box.meets(box_of(p_[f], p_[f + 1])))
          meet_edges({p_[e], p_[e + 1], e, pair.i}, {p_[f], p_[f + 1], f, pair.j});
      }
    }
  }

  void meet_edges(const Part& e, const Part& f) {
    // Most pairs just follow each other in a ring; they meet elsewhere only when they run back.
    if (e.b == f.a && next(e.edge, e.run) == f.edge && orientation(e.a, e.b, f.b) != 0) return;
    if (f.b == e.a && next(f.edge, f.run) == e.edge && orientation(f.a, f.b, e.b) != 0) return;
    meet(e, f);
  }

  /// Marks where two parts meet, unless they just follow each other along a ring.
  void meet(const Part& s, const Part& t) {
    const int ta = orientation(s.a, s.b, t.a), tb = orientation(s.a, s.b, t.b);
    if (ta * tb > 0) return;
    const int sa = orientation(t.a, t.b, s.a), sb = orientation(t.a, t.b, s.b);
    if (sa * sb > 0) return;
    if (ta * tb < 0 && sa * sb < 0) {
      const Vec2d point = outline_.grid(
          crossing_of_parts({s.a, s.b}, {t.a, t.b}, {p_[s.edge], p_[s.edge + 1]}, {p_[t.edge], p_[t.edge + 1]}));
      const bool rounded = orientation(s.a, s.b, point) != 0 || orientation(t.a, t.b, point) != 0;
      const bool cuts_s = mark(s, point, rounded), cuts_t = mark(t, point, rounded);
      stuck_ |= !cuts_s && !cuts_t;
      return;
    }
    if (ta != 0 || tb != 0) {
      if (s.b == t.a && s.b == p_[s.edge + 1] && next(s.edge, s.run) == t.edge) return;
      if (t.b == s.a && t.b == p_[t.edge + 1] && next(t.edge, t.run) == s.edge) return;
    }
    touch(t.a, ta, s, t);
    touch(t.b, tb, s, t);
    touch(s.a, sa, t, s);
    touch(s.b, sb, t, s);
  }

  /// An end of one of two parts, and its side of the other.
  void touch(Vec2d point, int side, const Part& other, const Part& own) {
    if (side != 0 || !in_box({other.a, other.b}, point)) return;
    const bool inside = point != other.a && point != other.b;
    if (!inside && !is_vertex(own, point) && !is_vertex(other, point)) return;  // a mark of both
    mark(own, point, false);
    const bool cuts_other = mark(other, point, false);
    stuck_ |= inside && !cuts_other;
  }

  bool before(const Mark& m, const Mark& n) const {
    if (m.edge != n.edge) return m.edge < n.edge;
    const Vec2d a = p_[m.edge], b = p_[m.edge + 1];
    const int along_x = m.point.x == n.point.x ? 0 : (m.point.x < n.point.x) == (a.x < b.x) ? -1 : 1;
    const int along_y = m.point.y == n.point.y ? 0 : (m.point.y < n.point.y) == (a.y < b.y) ? -1 : 1;
    return is_steep(a, b) ? along_y < 0 || (along_y == 0 && along_x < 0) : along_x < 0 || (along_x == 0 && along_y < 0);
  }

  /// Sorts the fresh marks in, and notes which runs have parts to check. Parts of an edge with rounded marks may meet
  /// what their edge did not, or still cross what they were marked for: two points that rounding has exchanged leave
  /// the crossing between other marks than its own. So may, in later rounds, parts between exact marks: they replace
  /// others against which the rest has been checked.
  void merge_fresh(bool first_round) {
    const auto order = [&](const Mark& m, const Mark& n) { return before(m, n); };
    std::fill(changed_.begin(), changed_.end(), false);
    for (std::size_t i = 0; i < fresh_.size(); ++i) {
      const Mark& m = fresh_[i];
      if (m.rounded || !first_round) changed_[fresh_run_[i]] = true;
    }
    fresh_run_.clear();
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
    const auto old = static_cast<std::ptrdiff_t>(marks_.all.size());
    std::set_difference(fresh_.begin(), fresh_.end(), marks_.all.begin(), marks_.all.begin() + old,
                        std::back_inserter(added_), order);
    changed_edges_.assign(outline_.points.size(), false);
    for (const Mark& m : added_) {
      if (m.point == p_[m.edge]) continue;
      marks_.inside[m.edge] = true;
      if (m.rounded || !first_round) changed_edges_[m.edge] = true;
    }
    marks_.all.insert(marks_.all.end(), added_.begin(), added_.end());
    std::inplace_merge(marks_.all.begin(), marks_.all.begin() + old, marks_.all.end(), order);
    added_.clear();
    fresh_.clear();
  }

  void check_parts() {
    for (const BoxTree::Pair pair : pairs_) {
      if (changed_[pair.i] || changed_[pair.j]) check_runs(pair);
      if (work_ > budget_) return;
    }
    // Those that met in a vertex alone can do so in more only when rounding has moved both to the border of their
    // boxes.
    for (std::uint32_t j = 1; j < tree_.runs().size(); ++j) {
      if (runs_[j].apart && (changed_[j - 1] || changed_[j])) check_runs({j - 1, j});
    }
  }

  void check_runs(BoxTree::Pair pair) {
    const Run &r = runs_[pair.i], &s = runs_[pair.j];
    work_ += (r.last - r.first) * (s.last - s.first);
    for (std::uint32_t e = r.first; e < r.last; ++e) {
      const Box box = box_of(p_[e], p_[e + 1]);
      for (std::uint32_t f = s.first; f < s.last; ++f) {
        if (!changed_edges_[e] && !changed_edges_[f]) continue;
        const Box other = box_of(p_[f], p_[f + 1]);
        if (box.meets(other)) check_edges(e, pair.i, f, pair.j, common_part(box, other));
      }
    }
  }

  void check_edges(std::uint32_t e, std::uint32_t e_run, std::uint32_t f, std::uint32_t f_run, const Box& both) {
    for_parts(e, e_run, both, [&](const Part& s) {
      const Box box = box_of(s.a, s.b);
      if (!box.meets(both)) return;
      for_parts(f, f_run, box, [&](const Part& t) {
        if (box.meets(box_of(t.a, t.b))) meet(s, t);
      });
    });
  }

  /// Those that may meet the box, at least.
  template <typename Visit>
  void for_parts(std::uint32_t edge, std::uint32_t run, const Box& box, Visit visit) {
    const Vec2d start = p_[edge], end = p_[edge + 1];
    Vec2d a = start;
    if (marks_.inside[edge]) {
      const bool steep = is_steep(start, end), falls = steep ? end.y < start.y : end.x < start.x;
      // Along the axis that marks are sorted by, from where the edge starts.
      const auto way = [&](Vec2d p) { return falls ? -(steep ? p.y : p.x) : (steep ? p.y : p.x); };
      const double enter = std::min(way(box.low), way(box.high)), leave = std::max(way(box.low), way(box.high));
      const std::span<const Mark> marks = marks_.inside_of(edge, start);
      auto mark = std::partition_point(marks.begin(), marks.end(), [&](const Mark& m) { return way(m.point) < enter; });
      if (mark != marks.begin()) a = std::prev(mark)->point;
      for (; mark != marks.end(); ++mark) {
        visit(Part{a, mark->point, edge, run});
        a = mark->point;
        ++work_;
        if (way(a) > leave) return;
      }
    }
    visit(Part{a, end, edge, run});
  }

  const Outline& outline_;
  const Vec2d* p_;
  const BoxTree& tree_;
  const Run* runs_;
  std::vector<BoxTree::Pair> pairs_;
  Marks marks_;
  std::vector<Mark> fresh_, added_;
  std::vector<std::uint32_t> fresh_run_;       // where each fresh one was found
  std::vector<bool> changed_, changed_edges_;  // runs and edges with parts to check
  std::size_t most_pairs_, work_ = 0, budget_;
  bool stuck_ = false;  // parts of edges still meet in a mark of theirs: rounding has put it out of order
};

}  // namespace

std::span<const Mark> Marks::inside_of(std::uint32_t edge, Vec2d start) const {
  if (!inside[edge]) return {};
  auto begin =
      std::lower_bound(all.begin(), all.end(), edge, [](const Mark& m, std::uint32_t e) { return m.edge < e; });
  if (begin->point == start) ++begin;
  auto end = begin;
  for (int i = 0; i < 8 && end != all.end() && end->edge == edge; ++i) ++end;
  if (end != all.end() && end->edge == edge)
    end = std::partition_point(end, all.end(), [&](const Mark& m) { return m.edge == edge; });
  return {begin, end};
}

std::optional<Marks> find_marks(const Outline& outline, const BoxTree& tree, double patience) {
  const double edges = patience * static_cast<double>(outline.points.size());
  if (tree.expected_pairs() > most_expected * edges) return {};
  Finder finder(outline, tree, most_pairs * edges);
  if (!finder.find_all()) return {};
  return finder.take();
}

}  // namespace lambert::polygon::arrangement
