#include "lambert/polygon/arrangement/network.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lambert::polygon::arrangement {
namespace {

std::size_t hash(Vec2d p) {
  // Whole numbers differ in the high bits only, hence the finaliser of MurmurHash3 (Appleby), which spreads all bits.
  std::uint64_t bits = std::bit_cast<std::uint64_t>(p.x) ^ std::rotl(std::bit_cast<std::uint64_t>(p.y), 23);
  bits = (bits ^ bits >> 33) * 0xff51afd7ed558ccd;
  bits = (bits ^ bits >> 33) * 0xc4ceb9fe1a85ec53;
  return static_cast<std::size_t>(bits ^ bits >> 33);
}

bool smaller(Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Of two segments that both pass below one point, or through it, and do not cross: whether the first lies lower.
bool passes_lower(Segment s, Segment t) {
  if (s.a == t.a) return orientation(s.a, s.b, t.b) > 0;
  if (smaller(s.a, t.a)) return orientation(s.a, s.b, t.a) > 0;
  return orientation(t.a, t.b, s.a) < 0;
}

/// Connected parts of ways, each with its smallest point.
class Parts {
 public:
  explicit Parts(std::size_t nodes) : parent_(nodes) {
    for (std::uint32_t i = 0; i < nodes; ++i) parent_[i] = i;
  }
  std::uint32_t root(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

Network::Network(const Outline& outline, const BoxTree& tree, const Marks& marks)
    : outline_(outline), tree_(tree), marks_(marks) {
  const std::size_t expected = marks.all.size() + outline.ring_count();
  table_.assign(std::bit_ceil(2 * expected + 1), none);
  nodes_.reserve(expected);
  ways_.reserve(expected);
  make_ways();
  make_spokes();
  wind();
}

std::uint32_t Network::node_at(Vec2d p) {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t slot = hash(p) & mask;; slot = (slot + 1) & mask) {
    std::uint32_t& node = table_[slot];
    if (node == none) {
      node = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(p);
      return node;
    }
    if (nodes_[node] == p) return node;
  }
}

void Network::add_way(std::uint32_t from, std::uint32_t to, std::uint32_t begin, std::uint32_t end,
                      std::uint64_t start) {
  ways_.push_back({from, to, begin, end, start, outline_.winding_of(static_cast<std::size_t>(start >> 32))});
}

/// The start of every ring is a node as well, so that no way runs over it.
void Network::make_ways() {
  std::size_t m = 0;
  for (std::size_t ring = 0; ring < outline_.ring_count(); ++ring) {
    const std::uint32_t first = outline_.starts[ring], last = outline_.starts[ring + 1] - 1;
    const std::uint32_t start_node = node_at(outline_.points[first]);
    std::uint32_t from = start_node, begin = first + 1;
    std::uint64_t start = std::uint64_t{first} << 32;
    for (; m < marks_.all.size() && marks_.all[m].edge < last; ++m) {
      const Mark& mark = marks_.all[m];
      const bool is_vertex = mark.point == outline_.points[mark.edge];
      if (is_vertex && mark.edge == first) continue;
      const std::uint32_t node = node_at(mark.point);
      add_way(from, node, begin, is_vertex ? mark.edge : mark.edge + 1, start);
      const std::uint64_t inside = start >> 32 == mark.edge ? (start & 0xffffffff) + 1 : 1;
      from = node;
      begin = mark.edge + 1;
      start = std::uint64_t{mark.edge} << 32 | (is_vertex ? 0 : inside);
    }
    add_way(from, start_node, begin, last, start);
  }
}

Vec2d Network::direction(Spoke spoke) const {
  const Way& way = ways_[spoke.way];
  if (way.begin == way.end) return nodes_[spoke.leaves ? way.to : way.from];
  return outline_.points[spoke.leaves ? way.begin : way.end - 1];
}

void Network::make_spokes() {
  const auto count = static_cast<std::uint32_t>(nodes_.size());
  spoke_start_.assign(count + 1, 0);
  for (const Way& way : ways_) {
    ++spoke_start_[way.from + 1];
    ++spoke_start_[way.to + 1];
  }
  for (std::uint32_t i = 0; i < count; ++i) spoke_start_[i + 1] += spoke_start_[i];
  spokes_.resize(2 * ways_.size());
  std::vector<std::uint32_t> fill(spoke_start_.begin(), spoke_start_.end() - 1);
  for (std::uint32_t i = 0; i < ways_.size(); ++i) {
    spokes_[fill[ways_[i].from]++] = {i, true};
    spokes_[fill[ways_[i].to]++] = {i, false};
  }
  for (std::uint32_t node = 0; node < count; ++node) {
    sort_spokes(node);
    merge_same();
  }
}

/// Counter-clockwise, from straight down, which itself comes last.
void Network::sort_spokes(std::uint32_t node) {
  const Vec2d centre = nodes_[node];
  const auto earlier = [&](const DirectedSpoke& s, const DirectedSpoke& t) {
    return s.is_left != t.is_left ? t.is_left : orientation(centre, s.towards, t.towards) > 0;
  };
  directed_.clear();
  for (std::uint32_t i = spoke_start_[node]; i < spoke_start_[node + 1]; ++i) {
    const Vec2d towards = direction(spokes_[i]);
    directed_.push_back({towards, spokes_[i], smaller(towards, centre)});
  }
  if (directed_.size() <= 8) {
    for (std::size_t i = 1; i < directed_.size(); ++i) {
      const DirectedSpoke spoke = directed_[i];
      std::size_t at = i;
      for (; at > 0 && earlier(spoke, directed_[at - 1]); --at) directed_[at] = directed_[at - 1];
      directed_[at] = spoke;
    }
  } else {
    std::sort(directed_.begin(), directed_.end(), earlier);
  }
  for (std::size_t i = 0; i < directed_.size(); ++i) spokes_[spoke_start_[node] + i] = directed_[i].spoke;
}

/// Ways that leave in the same direction are one edge, the same for all.
void Network::merge_same() {
  for (std::size_t i = 0, j = 0; i < directed_.size(); i = j) {
    std::uint32_t first = directed_[i].spoke.way;
    for (j = i + 1; j < directed_.size() && directed_[j].towards == directed_[i].towards; ++j)
      first = std::min(first, directed_[j].spoke.way);
    if (j == i + 1) continue;
    Way& way = ways_[first];
    for (std::size_t k = i; k < j; ++k) {
      const std::uint32_t index = directed_[k].spoke.way;
      Way& other = ways_[index];
      if (index == first || other.same != none) continue;
      other.same = first;
      way.delta = way.delta + (other.from == way.from ? other.delta : -other.delta);
      other.delta = {};
    }
  }
}

template <typename Accept>
Network::Below Network::way_below(Vec2d v, Accept accept) const {
  Below found;
  Segment best{};
  double reached = tree_.whole().low.y;
  const Vec2d* const p = outline_.points.data();
  const auto consider = [&](Vec2d from, Vec2d to, std::uint32_t edge, std::size_t marks_before) {
    const bool leftwards = smaller(to, from);
    const Segment s = leftwards ? Segment{to, from} : Segment{from, to};
    if (!smaller(s.a, v) || !smaller(v, s.b) || orientation(s.a, s.b, v) <= 0) return;
    if (found.way != none && !passes_lower(best, s)) return;
    std::uint32_t way = way_of(edge, marks_before);
    bool turned = leftwards;
    if (const std::uint32_t same = ways_[way].same; same != none) {
      turned = leftwards != (ways_[same].from != ways_[way].from);
      way = same;
    }
    if (!accept(ways_[way])) return;
    found = {way, turned};
    best = s;
    // Its height at v, less what rounding could have added.
    const double t = (v.x - s.a.x) / (s.b.x - s.a.x), y = s.a.y + t * (s.b.y - s.a.y);
    reached = s.b.x > s.a.x ? y - 0x1p-40 * (std::abs(s.a.y) + std::abs(s.b.y)) : s.a.y;
  };
  tree_.visit_below(v, [&](std::uint32_t i) {
    const Run& run = tree_.runs()[i];
    for (std::uint32_t e = run.first; e < run.last; ++e) {
      const Box box = box_of(p[e], p[e + 1]);
      if (box.high.x < v.x || v.x < box.low.x || v.y < box.low.y || box.high.y < reached) continue;
      Vec2d from = p[e];
      std::size_t before = 0;
      for (const Mark& mark : marks_.inside_of(e, from)) {
        consider(from, mark.point, e, before++);
        from = mark.point;
      }
      consider(from, p[e + 1], e, before);
    }
    return reached;
  });
  return found;
}

std::uint32_t Network::way_of(std::uint32_t edge, std::size_t marks_before) const {
  const std::uint64_t place = std::uint64_t{edge} << 32 | marks_before;
  const auto after = std::upper_bound(ways_.begin(), ways_.end(), place,
                                      [](std::uint64_t at, const Way& way) { return at < way.start; });
  return static_cast<std::uint32_t>(after - ways_.begin()) - 1;
}

/// Windings, part after part from left to right, so that what lies below the smallest point of a part is known.
void Network::wind() {
  struct Start {
    Vec2d point;
    std::uint32_t way;
  };
  Parts parts(nodes_.size());
  for (const Way& way : ways_) {
    if (way.delta != Winding{}) parts.join(way.from, way.to);
  }
  std::vector<std::uint32_t> start_of(nodes_.size(), none);
  std::vector<Start> starts;
  for (std::uint32_t i = 0; i < ways_.size(); ++i) {
    const Way& way = ways_[i];
    if (way.delta == Winding{}) continue;
    Vec2d least = smaller(nodes_[way.to], nodes_[way.from]) ? nodes_[way.to] : nodes_[way.from];
    for (std::uint32_t v = way.begin; v < way.end; ++v) {
      if (smaller(outline_.points[v], least)) least = outline_.points[v];
    }
    std::uint32_t& start = start_of[parts.root(way.from)];
    if (start == none) {
      start = static_cast<std::uint32_t>(starts.size());
      starts.push_back({least, i});
    } else if (smaller(least, starts[start].point)) {
      starts[start] = {least, i};
    }
  }
  std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return smaller(a.point, b.point); });

  wound_.assign(ways_.size(), false);
  node_wound_.assign(nodes_.size(), false);
  bool first = true;
  for (const Start& start : starts) {
    Winding outside;
    if (!first) {
      const Below below = way_below(start.point, [](const Way& way) { return way.delta != Winding{}; });
      if (below.way != none) outside = below.leftwards ? ways_[below.way].right : left(ways_[below.way]);
    }
    first = false;
    Way& way = ways_[start.way];
    std::uint32_t at = way.begin;
    while (at < way.end && outline_.points[at] != start.point) ++at;
    std::uint32_t lowest = start.way;
    bool leaves = true;
    if (at < way.end) {
      const Vec2d before = at == way.begin ? nodes_[way.from] : outline_.points[at - 1];
      const Vec2d after = at + 1 == way.end ? nodes_[way.to] : outline_.points[at + 1];
      leaves = orientation(start.point, after, before) > 0;
    } else {
      const std::uint32_t node = nodes_[way.from] == start.point ? way.from : way.to;
      std::uint32_t spoke = spoke_start_[node];
      while (ways_[spokes_[spoke].way].delta == Winding{}) ++spoke;
      lowest = spokes_[spoke].way;
      leaves = spokes_[spoke].leaves;
    }
    // Right of what leaves lowest, and left of what arrives lowest, is below.
    ways_[lowest].right = leaves ? outside : outside - ways_[lowest].delta;
    wind_from(lowest);
  }
}

void Network::wind_from(std::uint32_t start) {
  open_.assign(1, start);
  wound_[start] = true;
  while (!open_.empty()) {
    const std::uint32_t way = open_.back();
    open_.pop_back();
    wind_around(ways_[way].from);
    wind_around(ways_[way].to);
  }
}

/// Between spokes the winding is constant.
void Network::wind_around(std::uint32_t node) {
  if (node_wound_[node]) return;
  node_wound_[node] = true;
  const std::uint32_t begin = spoke_start_[node], end = spoke_start_[node + 1];
  std::uint32_t known = begin;
  while (!wound_[spokes_[known].way]) ++known;
  const auto after = [&](Spoke spoke) {
    const Way& way = ways_[spoke.way];
    return spoke.leaves ? left(way) : way.right;
  };
  Winding between = after(spokes_[known]);
  const auto pass = [&](std::uint32_t i) {
    const Spoke spoke = spokes_[i];
    Way& way = ways_[spoke.way];
    if (way.delta == Winding{}) return;
    if (!wound_[spoke.way]) {
      wound_[spoke.way] = true;
      way.right = spoke.leaves ? between : between - way.delta;
      open_.push_back(spoke.way);
    }
    between = after(spoke);
  };
  for (std::uint32_t i = known + 1; i < end; ++i) pass(i);
  for (std::uint32_t i = begin; i < known; ++i) pass(i);
}

Regions Network::select(const Selection& selection) const {
  Boundary boundary{nodes_, {}, outline_.points};
  std::vector<std::uint32_t> arc_of(ways_.size(), none);
  const auto is_boundary = [&](const Way& way) {
    return arc_of[static_cast<std::size_t>(&way - ways_.data())] != none;
  };
  for (std::uint32_t i = 0; i < ways_.size(); ++i) {
    const Way& way = ways_[i];
    if (way.delta == Winding{}) continue;
    const bool in_left = selection.contains(left(way)), in_right = selection.contains(way.right);
    if (in_left == in_right) continue;
    arc_of[i] = static_cast<std::uint32_t>(boundary.arcs.size());
    boundary.arcs.push_back(in_left ? Arc{way.from, way.to, way.begin, way.end, false}
                                    : Arc{way.to, way.from, way.begin, way.end, true});
  }
  return regions_of(boundary, [&](Vec2d v, std::uint32_t) { return arc_of[way_below(v, is_boundary).way]; });
}

}  // namespace lambert::polygon::arrangement
