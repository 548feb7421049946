#include "lambert/polygon/edge_hits.h"

#include "lambert/polygon/line_order.h"
#include "lambert/polygon/predicates.h"
#include "lambert/polygon/scale.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lambert::polygon {
namespace {

struct PlacedHit {
  LinePlace from, to;
  std::size_t ring, edge;
};

/// Judges single edges, which are given `scale` times their size, as are a and b.
class Hits {
 public:
  Hits(Vec2d a, Vec2d b, Reach reach, double scale) : a_(a), b_(b), reach_(reach), scale_(scale), order_(a, b) {}

  std::optional<PlacedHit> of_edge(Vec2d c, Vec2d d, std::size_t ring, std::size_t edge) const {
    const int from = orientation(a_, b_, c), to = orientation(a_, b_, d);
    PlacedHit hit{{c, c}, {c, c}, ring, edge};
    if (from == 0 && to == 0) {
      if (order_.compare({c, c}, {d, d}) <= 0) {
        hit.to = {d, d};
      } else {
        hit.from = {d, d};
      }
    } else if (from * to < 0) {
      hit.from = hit.to = from < 0 ? LinePlace{c, d} : LinePlace{d, c};
    } else if (from != 0) {
      return std::nullopt;
    }
    const LinePlace start{a_, a_}, end{b_, b_};
    if (reach_ != Reach::line) {
      if (order_.compare(hit.to, start) < 0) return std::nullopt;
      if (order_.compare(hit.from, start) < 0) hit.from = start;
    }
    if (reach_ == Reach::segment) {
      if (order_.compare(hit.from, end) > 0) return std::nullopt;
      if (order_.compare(hit.to, end) > 0) hit.to = end;
    }
    return hit;
  }

  bool before(const PlacedHit& p, const PlacedHit& q) const {
    const int order = order_.compare(p.from, q.from);
    return order != 0 ? order < 0 : std::pair(p.ring, p.edge) < std::pair(q.ring, q.edge);
  }

  std::vector<EdgeHit> sorted(std::vector<PlacedHit> hits) const {
    std::stable_sort(hits.begin(), hits.end(), [this](const auto& p, const auto& q) { return before(p, q); });
    std::vector<EdgeHit> finished;
    for (const PlacedHit& hit : hits) finished.push_back(finish(hit));
    return finished;
  }

  EdgeHit finish(const PlacedHit& p) const {
    return {p.ring,
            p.edge,
            order_.parameter(p.from),
            order_.parameter(p.to),
            order_.point(p.from) / scale_,
            order_.point(p.to) / scale_};
  }

 private:
  Vec2d a_, b_;
  Reach reach_;
  double scale_;
  LineOrder order_;
};

template <class Use>
void for_each_edge(const Rings& rings, Use use) {
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r].size(); ++i) use(rings[r][i], rings[r][next_index(i, rings[r].size())], r, i);
}

/// Whether a box lies wholly on one side of the line, or, within reach, beyond one of its ends. Exact, and so never of
/// a box that holds a hit.
bool misses(const Box2& box, Vec2d a, Vec2d b, Reach reach) {
  const Vec2d d = b - a;
  // The corners farthest to the left and to the right.
  const Vec2d left(b.y > a.y ? box.min.x : box.max.x, b.x > a.x ? box.max.y : box.min.y);
  const Vec2d right(b.y > a.y ? box.max.x : box.min.x, b.x > a.x ? box.min.y : box.max.y);
  if (orientation(a, b, left) < 0 || orientation(a, b, right) > 0) return true;
  if (reach == Reach::segment) return !box.overlaps(box_of(std::array{a, b}));
  if (reach == Reach::ray)
    return (d.x >= 0 && box.max.x < a.x) || (d.x <= 0 && box.min.x > a.x) || (d.y >= 0 && box.max.y < a.y) ||
           (d.y <= 0 && box.min.y > a.y);
  return false;
}

double common_scale(const Rings& rings, Vec2d a, Vec2d b) {
  Sizes sizes = sizes_of(rings);
  sizes.add(a), sizes.add(b);
  return safe_scale(sizes);
}

}  // namespace

std::vector<EdgeHit> edge_hits(const Rings& rings, Vec2d a, Vec2d b, Reach reach) {
  if (a == b) return {};
  const double scale = common_scale(rings, a, b);
  const Hits hits(scale * a, scale * b, reach, scale);
  std::vector<PlacedHit> found;
  for_each_edge(rings, [&](Vec2d c, Vec2d d, std::size_t r, std::size_t i) {
    if (const auto hit = hits.of_edge(scale * c, scale * d, r, i)) found.push_back(*hit);
  });
  return hits.sorted(std::move(found));
}

std::optional<EdgeHit> first_edge_hit(const Rings& rings, Vec2d a, Vec2d b, Reach reach) {
  if (a == b) return std::nullopt;
  const double scale = common_scale(rings, a, b);
  const Hits hits(scale * a, scale * b, reach, scale);
  std::optional<PlacedHit> first;
  for_each_edge(rings, [&](Vec2d c, Vec2d d, std::size_t r, std::size_t i) {
    if (const auto hit = hits.of_edge(scale * c, scale * d, r, i); hit && (!first || hits.before(*hit, *first)))
      first = hit;
  });
  return first ? std::optional(hits.finish(*first)) : std::nullopt;
}

EdgeTree::EdgeTree(const Rings& rings) : scale_(safe_scale(sizes_of(rings))) {
  for_each_edge(rings, [&](Vec2d c, Vec2d d, std::size_t r, std::size_t i) {
    edges_.push_back({scale_ * c, scale_ * d, r, i});
  });
  if (!edges_.empty()) build(0, static_cast<std::uint32_t>(edges_.size()));
}

std::uint32_t EdgeTree::build(std::uint32_t first, std::uint32_t count) {
  constexpr std::uint32_t leaf_size = 8;
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  const auto begin = edges_.begin() + first;
  Box2 box;
  for (auto e = begin; e != begin + count; ++e) box.add(e->from), box.add(e->to);
  nodes_.push_back({box, first, count, 0});
  if (count <= leaf_size) return index;
  const int axis = box.size().x >= box.size().y ? 0 : 1;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [axis](const Edge& p, const Edge& q) {
    return 0.5 * p.from[axis] + 0.5 * p.to[axis] < 0.5 * q.from[axis] + 0.5 * q.to[axis];
  });
  build(first, half);
  const std::uint32_t second = build(first + half, count - half);
  nodes_[index].second = second;
  return index;
}

template <class Use>
void EdgeTree::visit(const Query& query, Use use) const {
  if (nodes_.empty() || query.a == query.b) return;
  std::vector<std::uint32_t> stack{0};
  while (!stack.empty()) {
    const std::uint32_t index = stack.back();
    stack.pop_back();
    const Node& node = nodes_[index];
    const Box2 box{query.factor * node.box.min, query.factor * node.box.max};
    if (misses(box, query.a, query.b, query.reach)) continue;
    if (node.second != 0) {
      stack.push_back(node.second);
      stack.push_back(index + 1);
    } else {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Edge& e = edges_[i];
        use(query.factor * e.from, query.factor * e.to, e);
      }
    }
  }
}

/// Edges come to the query where scaling would round it.
EdgeTree::Query EdgeTree::query(Vec2d a, Vec2d b, Reach reach) const {
  if (keeps(scale_, a) && keeps(scale_, b)) return {scale_ * a, scale_ * b, reach, 1, scale_};
  return {a, b, reach, 1 / scale_, 1};
}

std::vector<EdgeHit> EdgeTree::edge_hits(Vec2d a, Vec2d b, Reach reach) const {
  const Query q = query(a, b, reach);
  const Hits hits(q.a, q.b, reach, q.scale);
  std::vector<PlacedHit> found;
  visit(q, [&](Vec2d from, Vec2d to, const Edge& e) {
    if (const auto hit = hits.of_edge(from, to, e.ring, e.index)) found.push_back(*hit);
  });
  return hits.sorted(std::move(found));
}

std::optional<EdgeHit> EdgeTree::first_edge_hit(Vec2d a, Vec2d b, Reach reach) const {
  const Query q = query(a, b, reach);
  const Hits hits(q.a, q.b, reach, q.scale);
  std::optional<PlacedHit> first;
  visit(q, [&](Vec2d from, Vec2d to, const Edge& e) {
    if (const auto hit = hits.of_edge(from, to, e.ring, e.index); hit && (!first || hits.before(*hit, *first)))
      first = hit;
  });
  return first ? std::optional(hits.finish(*first)) : std::nullopt;
}

}  // namespace lambert::polygon
