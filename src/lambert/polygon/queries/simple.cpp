#include "lambert/polygon/queries/simple.h"

#include "lambert/polygon/queries/collinear_edges.h"
#include "lambert/polygon/sweep/sweep.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace lambert::polygon {
namespace {

using Kind = Simplicity::Kind;

std::vector<Segment> edges_of(const Ring& ring) {
  std::vector<Segment> edges;
  edges.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[next_index(i, ring.size())]});
  return edges;
}

Simplicity witness(Kind kind, std::size_t i, std::size_t k, Vec2d point) {
  return {kind, std::min(i, k), std::max(i, k), point};
}

/// Stops where an edge has a point of another inside; remembers a vertex that is visited twice.
class SelfMeeting : public SweepVisitor {
 public:
  SelfMeeting(const std::vector<Segment>& edges, double scale) : edges_(edges), scale_(scale) {}

  bool crossing(std::uint32_t s, std::uint32_t t) override {
    found_ = witness(Kind::edges_cross, s, t, intersect(edges_[s], edges_[t]).from);
    return false;
  }

  bool at_point(const SweepPoint& p) override {
    if (!p.through.empty()) {
      const auto other = !p.ending.empty()     ? p.ending[0]
                         : !p.starting.empty() ? p.starting[0]
                         : !p.points.empty()   ? p.points[0]
                                               : p.through.back();
      found_ = witness(Kind::edges_cross, p.through[0], other, p.point / scale_);
      return false;
    }
    // Each vertex ends one edge and starts another; an edge without length has two vertices here.
    if (!found_ && p.ending.size() + p.starting.size() + 2 * p.points.size() > 2) found_ = vertices_at(p);
    return true;
  }

  Simplicity result() const { return found_.value_or(Simplicity{}); }

 private:
  Simplicity vertices_at(const SweepPoint& p) const {
    std::vector<std::size_t> vertices;
    for (const auto& part : {p.ending, p.starting, p.points})
      for (const std::size_t e : part) {
        if (scale_ * edges_[e].a == p.point) vertices.push_back(e);
        if (scale_ * edges_[e].b == p.point) vertices.push_back(next_index(e, edges_.size()));
      }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return witness(Kind::vertex_twice, vertices[0], vertices[1], edges_[vertices[0]].a);
  }

  const std::vector<Segment>& edges_;
  double scale_;
  std::optional<Simplicity> found_;
};

bool successive(std::size_t i, std::size_t k, std::size_t n) { return next_index(i, n) == k || next_index(k, n) == i; }

/// What two edges make of the ring.
Simplicity judge(const std::vector<Segment>& edges, std::size_t i, std::size_t k) {
  const Segment &v = edges[i], &w = edges[k];
  const SegmentMeeting m = intersect(v, w);
  if (!m.meet()) return {};
  if (m.from != m.to) {
    return witness(successive(i, k, edges.size()) ? Kind::spike : Kind::edges_coincide, i, k, m.from);
  }
  const auto ends = [&](const Segment& s) { return m.from == s.a || m.from == s.b; };
  return ends(v) && ends(w) ? Simplicity{} : witness(Kind::edges_cross, i, k, m.from);
}

}  // namespace

Simplicity check_simple(const Ring& ring) {
  if (ring.size() < 3) return {Kind::too_few};
  const std::vector<Segment> edges = edges_of(ring);
  const SweepSegments prepared = prepare_sweep(edges);
  if (const auto overlap = find_overlap(prepared)) {
    const Kind kind = overlap->successive ? Kind::spike : Kind::edges_coincide;
    return witness(kind, overlap->first, overlap->second, overlap->from);
  }
  SelfMeeting visitor(edges, prepared.scale);
  sweep(prepared, visitor);
  return visitor.result();
}

Simplicity check_simple_by_pairs(const Ring& ring) {
  if (ring.size() < 3) return {Kind::too_few};
  const std::vector<Segment> edges = edges_of(ring);
  Simplicity worst;
  for (std::size_t k = 1; k < ring.size(); ++k)
    for (std::size_t i = 0; i < k; ++i) {
      const Simplicity twice = ring[i] == ring[k] ? witness(Kind::vertex_twice, i, k, ring[i]) : Simplicity{};
      for (const Simplicity& s : {twice, judge(edges, i, k)})
        if (s.kind > worst.kind) worst = s;
    }
  return worst;
}

std::string message_of(const Simplicity& s) {
  const auto say = [&](const char* what, const char* does) {
    char text[160];
    std::snprintf(text, sizeof text, "%s %zu and %zu %s at (%.17g, %.17g)", what, s.first, s.second, does, s.point.x,
                  s.point.y);
    return std::string(text);
  };
  switch (s.kind) {
    case Kind::simple: return {};
    case Kind::too_few: return "fewer than three vertices";
    case Kind::vertex_twice: return say("vertices", "coincide");
    case Kind::edges_cross: return say("edges", "meet");
    case Kind::spike: return say("edges", "fold back on each other");
    case Kind::edges_coincide: return say("edges", "coincide");
  }
  return {};
}

}  // namespace lambert::polygon
