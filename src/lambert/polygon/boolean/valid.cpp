#include "lambert/polygon/boolean/valid.h"

#include "lambert/polygon/arrangement/outline.h"
#include "lambert/polygon/predicates/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace lambert::polygon {
namespace {

using arrangement::Outline;

struct RingEdge {
  Vec2d a, b;  // a is lexicographically smaller
  std::uint32_t ring;
  bool rightwards;          // the ring runs from a to b
  Vec2d before_a, after_b;  // the ring's vertices beyond both ends

  int delta() const { return rightwards ? 1 : -1; }  // winding above less winding below
};

/// One ring's way through a point where rings meet.
struct Pass {
  Vec2d at, from, to;
  std::uint32_t ring;

  bool operator==(const Pass&) const = default;
  bool operator<(const Pass& o) const {
    const int by_place = compare_xy(at, o.at);
    return by_place != 0 ? by_place < 0 : ring < o.ring;
  }
};

struct Finding {
  Defect defect;
  std::uint32_t ring;
  Vec2d at;
};
using Findings = std::optional<Finding>;

std::vector<RingEdge> edges_of(const Outline& outline) {
  std::vector<RingEdge> edges;
  for (std::uint32_t ring = 0; ring < outline.ring_count(); ++ring) {
    const Vec2d* const p = outline.points.data() + outline.starts[ring];
    const std::size_t size = outline.starts[ring + 1] - outline.starts[ring] - 1;
    for (std::size_t i = 0; i < size; ++i) {
      const Vec2d a = p[i], b = p[i + 1], before = p[previous_index(i, size)],
                  after = p[next_index(i + 1 == size ? 0 : i + 1, size)];
      const bool rightwards = compare_xy(a, b) < 0;
      edges.push_back(rightwards ? RingEdge{a, b, ring, true, before, after}
                                 : RingEdge{b, a, ring, false, after, before});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const RingEdge& e, const RingEdge& f) { return compare_xy(e.a, f.a) < 0; });
  return edges;
}

Pass pass_of(const RingEdge& e, Vec2d at) {
  const Vec2d low = at == e.a ? e.before_a : e.a, high = at == e.b ? e.after_b : e.b;
  return {at, e.rightwards ? low : high, e.rightwards ? high : low, e.ring};
}

/// Two edges whose boxes meet: a defect, or passes where they touch.
Findings check_pair(const RingEdge& e, const RingEdge& f, std::vector<Pass>& passes) {
  const int ea = orientation(f.a, f.b, e.a), eb = orientation(f.a, f.b, e.b);
  const int fa = orientation(e.a, e.b, f.a), fb = orientation(e.a, e.b, f.b);
  if (ea * eb > 0 || fa * fb > 0) return {};
  if (ea == 0 && eb == 0) {
    const Vec2d low = compare_xy(e.a, f.a) < 0 ? f.a : e.a, high = compare_xy(e.b, f.b) < 0 ? e.b : f.b;
    if (compare_xy(low, high) < 0) return Finding{Defect::edges_overlap, e.ring, low};
    if (compare_xy(low, high) > 0) return {};
  } else if (ea * eb < 0 && fa * fb < 0) {
    return Finding{e.ring == f.ring ? Defect::ring_meets_itself : Defect::rings_cross, e.ring, e.a};
  }
  const Vec2d at = ea == 0 && on_segment(f.a, f.b, e.a)   ? e.a
                   : eb == 0 && on_segment(f.a, f.b, e.b) ? e.b
                   : fa == 0                              ? f.a
                                                          : f.b;
  const Pass p = pass_of(e, at), q = pass_of(f, at);
  if (e.ring != f.ring) {
    passes.push_back(p);
    passes.push_back(q);
  } else if (p != q) {
    return Finding{Defect::ring_meets_itself, e.ring, at};
  }
  return {};
}

Findings check_pairs(const std::vector<RingEdge>& edges, std::vector<Pass>& passes) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const RingEdge& e = edges[i];
    const double low = std::min(e.a.y, e.b.y), high = std::max(e.a.y, e.b.y);
    for (std::size_t j = i + 1; j < edges.size() && edges[j].a.x <= e.b.x; ++j) {
      const RingEdge& f = edges[j];
      if (std::max(f.a.y, f.b.y) < low || std::min(f.a.y, f.b.y) > high) continue;
      if (const Findings found = check_pair(e, f, passes)) return found;
    }
  }
  return {};
}

/// Whether passes through one point nest around it: none crosses another.
bool passes_cross(const std::vector<Pass>& passes) {
  struct Spoke {
    Vec2d towards;
    std::uint32_t ring;
  };
  std::vector<Spoke> spokes;
  for (const Pass& pass : passes) {
    spokes.push_back({pass.from, pass.ring});
    spokes.push_back({pass.to, pass.ring});
  }
  const Vec2d centre = passes.front().at;
  std::sort(spokes.begin(), spokes.end(), [&](const Spoke& s, const Spoke& t) {
    const bool s_left = compare_xy(s.towards, centre) < 0, t_left = compare_xy(t.towards, centre) < 0;
    return s_left != t_left ? t_left : orientation(centre, s.towards, t.towards) > 0;
  });
  std::vector<std::uint32_t> open;
  for (const Spoke& spoke : spokes) {
    if (!open.empty() && open.back() == spoke.ring) {
      open.pop_back();
    } else {
      open.push_back(spoke.ring);
    }
  }
  return !open.empty();
}

/// Of a region, rings that touch each other in a cycle cut its interior apart.
class Forest {
 public:
  explicit Forest(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// False when both were connected already.
  bool join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::size_t root(std::size_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  std::vector<std::size_t> parent_;
};

Findings check_touching(std::vector<Pass>& passes, const std::vector<std::size_t>& region_of) {
  std::sort(passes.begin(), passes.end());
  passes.erase(std::unique(passes.begin(), passes.end()), passes.end());
  Forest forest(region_of.size());
  for (std::size_t begin = 0, end = 0; begin < passes.size(); begin = end) {
    while (end < passes.size() && passes[end].at == passes[begin].at) ++end;
    if (passes_cross(
            {passes.begin() + static_cast<std::ptrdiff_t>(begin), passes.begin() + static_cast<std::ptrdiff_t>(end)}))
      return Finding{Defect::rings_cross, passes[begin].ring, passes[begin].at};
    // Sorted by ring, so that rings of a region stand together.
    for (std::size_t i = begin + 1; i < end; ++i) {
      const std::uint32_t ring = passes[i].ring, previous = passes[i - 1].ring;
      if (region_of[ring] == region_of[previous] && !forest.join(ring, previous))
        return Finding{Defect::disconnected, ring, passes[i].at};
    }
  }
  return {};
}

/// The two edges that start at the smallest vertex of a ring: which side of them is inside how often.
Findings check_start(const RingEdge& first, const std::vector<const RingEdge*>& active,
                     const std::vector<std::size_t>& region_of) {
  const Vec2d v = first.a;
  const std::size_t region = region_of[first.ring];
  int all = 0, own = 0;
  std::vector<const RingEdge*> through;
  for (const RingEdge* edge : active) {
    const int side = edge->a == v ? 0 : orientation(edge->a, edge->b, v);
    if (side == 0) {
      through.push_back(edge);
    } else if (side > 0) {
      all += edge->delta();
      if (region_of[edge->ring] == region) own += edge->delta();
    }
  }
  std::sort(through.begin(), through.end(),
            [&](const RingEdge* e, const RingEdge* f) { return orientation(v, e->b, f->b) > 0; });
  for (const RingEdge* edge : through) {
    const std::array<int, 2> below{all, own};
    all += edge->delta();
    if (region_of[edge->ring] == region) own += edge->delta();
    if (edge->ring != first.ring) continue;
    const std::array<int, 2> above{all, own};
    if ((edge->rightwards ? above : below) != std::array{1, 1} ||
        (edge->rightwards ? below : above) != std::array{0, 0})
      return Finding{Defect::nesting, first.ring, v};
  }
  return {};
}

Findings check_nesting(const std::vector<RingEdge>& edges, const std::vector<std::size_t>& region_of) {
  std::vector<bool> seen(region_of.size());
  std::vector<const RingEdge*> active;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    const Vec2d v = edges[begin].a;
    std::erase_if(active, [&](const RingEdge* edge) { return compare_xy(edge->b, v) <= 0; });
    for (; end < edges.size() && edges[end].a == v; ++end) active.push_back(&edges[end]);
    for (std::size_t i = begin; i < end; ++i) {
      if (seen[edges[i].ring]) continue;
      seen[edges[i].ring] = true;
      if (const Findings found = check_start(edges[i], active, region_of)) return found;
    }
  }
  return {};
}

Findings check_orientation(const Outline& outline, const std::vector<std::size_t>& region_of) {
  for (std::uint32_t ring = 0; ring < outline.ring_count(); ++ring) {
    const Vec2d* const p = outline.points.data() + outline.starts[ring];
    const std::size_t size = outline.starts[ring + 1] - outline.starts[ring] - 1;
    const auto smaller = [](Vec2d a, Vec2d b) { return compare_xy(a, b) < 0; };
    const auto i = static_cast<std::size_t>(std::min_element(p, p + size, smaller) - p);
    const int turn = orientation(p[previous_index(i, size)], p[i], p[next_index(i, size)]);
    const bool outer = ring == 0 || region_of[ring] != region_of[ring - 1];
    if (turn != (outer ? 1 : -1)) return Finding{Defect::orientation, ring, p[i]};
  }
  return {};
}

Findings check_points(const Rings& rings) {
  for (std::uint32_t ring = 0; ring < rings.size(); ++ring) {
    const Ring& r = rings[ring];
    if (r.size() < 3) return Finding{Defect::too_few_points, ring, r.empty() ? Vec2d(0, 0) : r.front()};
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (!std::isfinite(r[i].x) || !std::isfinite(r[i].y)) return Finding{Defect::not_finite, ring, r[i]};
      if (r[i] == r[next_index(i, r.size())]) return Finding{Defect::too_few_points, ring, r[i]};
    }
  }
  return {};
}

Findings check_rings(const Rings& rings, const std::vector<std::size_t>& region_of) {
  if (const Findings found = check_points(rings)) return found;
  const Outline outline = arrangement::outline_of(rings, {});
  std::vector<RingEdge> edges = edges_of(outline);
  std::vector<Pass> passes;
  Findings found = check_orientation(outline, region_of);
  if (!found) found = check_pairs(edges, passes);
  if (!found) found = check_touching(passes, region_of);
  if (!found) found = check_nesting(edges, region_of);
  if (found) found->at = Vec2d(std::ldexp(found->at.x, outline.exponent), std::ldexp(found->at.y, outline.exponent));
  return found;
}

}  // namespace

std::optional<Invalidity> check_valid(const Regions& regions) {
  std::vector<std::size_t> region_of, first_ring;
  for (std::size_t region = 0; region < regions.size(); ++region) {
    first_ring.push_back(region_of.size());
    region_of.insert(region_of.end(), 1 + regions[region].holes.size(), region);
  }
  const Findings found = check_rings(rings_of(regions), region_of);
  if (!found) return {};
  const std::size_t region = region_of[found->ring];
  return Invalidity{found->defect, region, found->ring - first_ring[region], found->at};
}

std::string Invalidity::message() const {
  constexpr std::array words{"a coordinate is not finite",
                             "fewer than three different points in succession",
                             "the ring meets itself",
                             "the ring crosses another",
                             "an edge lies along another",
                             "the ring runs the wrong way round",
                             "the ring does not lie where its region needs it",
                             "the interior of the region falls apart"};
  return "region " + std::to_string(region) + ", ring " + std::to_string(ring) + ", near (" + std::to_string(at.x) +
         ", " + std::to_string(at.y) + "): " + words[static_cast<std::size_t>(defect)];
}

}  // namespace lambert::polygon
