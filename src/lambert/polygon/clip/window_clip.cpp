#include "lambert/polygon/clip/window_clip.h"

#include "lambert/polygon/clip/bridges.h"
#include "lambert/polygon/clip/clip_machine.h"

#include <algorithm>

namespace lambert::polygon {
namespace {

/// Decides each side once; crossings lie on the line by definition.
struct SidedLine {
  ClipLine line;
  int side(const SidedVertex& v) const { return v.side; }
  SidedVertex crossing(const SidedVertex& a, const SidedVertex& b) const {
    return {line.crossing(a.position, b.position), 0};
  }
};

}  // namespace

Rings clip_to_half_plane(const Rings& rings, const ClipLine& line) {
  std::vector<std::vector<SidedVertex>> sided;
  bool any_cut = false;
  for (const Ring& ring : rings) {
    std::vector<SidedVertex> vertices;
    bool cut = false;
    for (const Vec2d p : ring) {
      vertices.push_back({p, line.side(p)});
      cut = cut || vertices.back().side < 0;
    }
    any_cut = any_cut || cut;
    sided.push_back(cut ? clip_chain(std::span<const SidedVertex>(vertices), SidedLine{line}) : std::move(vertices));
  }
  if (!any_cut) return rings;
  return without_bridges(sided, line);
}

Rings clip_to_rectangle(const Rings& rings, Vec2d min, Vec2d max) {
  if (!(min.x <= max.x && min.y <= max.y)) return {};
  Rings clipped = rings;
  for (const ClipLine& line : {keep_x_from(min.x), keep_x_to(max.x), keep_y_from(min.y), keep_y_to(max.y)})
    clipped = clip_to_half_plane(clipped, line);
  return clipped;
}

Rings clip_to_convex(const Rings& rings, const Ring& window) {
  bool has_area = false;
  Rings clipped = rings;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const ClipLine line{window[i], window[next_index(i, window.size())]};
    has_area = has_area || std::any_of(window.begin(), window.end(), [&](Vec2d p) { return line.side(p) > 0; });
    if (line.tail != line.head) clipped = clip_to_half_plane(clipped, line);
  }
  return has_area ? clipped : Rings{};
}

}  // namespace lambert::polygon
