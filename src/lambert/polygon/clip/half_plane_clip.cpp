#include "lambert/polygon/clip/half_plane_clip.h"

namespace lambert::polygon {
namespace {

struct NamingLine {
  ClipLine line;
  std::string_view names;
  std::size_t* used;

  int side(const LabelledVertex& v) const { return line.side(v.position); }
  LabelledVertex crossing(const LabelledVertex& a, const LabelledVertex& b) const {
    const std::size_t i = (*used)++;
    std::string label = names.empty() ? std::string() : std::string(1, names[i % names.size()]);
    if (names.empty() || i >= names.size()) label += std::to_string(names.empty() ? i : i / names.size());
    return {line.crossing(a.position, b.position), std::move(label), true};
  }
};

}  // namespace

Ring sutherland_hodgman(const Ring& ring, const ClipLine& line) {
  return clip_chain(std::span<const Vec2d>(ring), line);
}

Ring sutherland_hodgman(const Ring& ring, std::span<const ClipLine> lines) {
  return clip_at_once(std::span<const Vec2d>(ring), lines).chain;
}

ClipTrace trace_clip(std::span<const LabelledVertex> ring, const ClipLine& line, std::string_view names) {
  ClipTrace trace;
  std::size_t used = 0;
  ClipMachine<LabelledVertex, NamingLine> machine(NamingLine{line, names, &used});
  std::vector<std::string> output;
  const auto keep = [&](const LabelledVertex& v) {
    output.push_back(v.label);
    trace.ring.push_back(v);
  };
  const auto write_down = [&](const LabelledVertex& v, ClipState state) {
    trace.steps.push_back({v.label, state, std::exchange(output, {})});
  };
  for (const LabelledVertex& v : ring) write_down(v, machine.next(v, keep));
  if (!ring.empty()) write_down(ring.front(), machine.close(keep));
  return trace;
}

std::vector<std::pair<LabelledVertex, LabelledVertex>> edges_of_new_vertices(const ClipTrace& trace) {
  std::vector<std::pair<LabelledVertex, LabelledVertex>> edges;
  for (std::size_t i = 0; i < trace.ring.size(); ++i) {
    const LabelledVertex &a = trace.ring[i], &b = trace.ring[next_index(i, trace.ring.size())];
    if (a.is_new && b.is_new) edges.emplace_back(a, b);
  }
  return edges;
}

}  // namespace lambert::polygon
