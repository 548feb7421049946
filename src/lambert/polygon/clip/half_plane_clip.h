#pragma once
/// Sutherland and Hodgman's clipping of one ring, as it is: concave rings come out with edges along the boundary that
/// join what should be separate (window_clip.h removes them), a ring that only touches the half-plane as a ring without
/// area.

#include "lambert/polygon/clip/clip_line.h"
#include "lambert/polygon/clip/clip_machine.h"
#include "lambert/polygon/ring.h"

#include <string>

namespace lambert::polygon {

/// What of the ring lies left of the line or on it, beginning after its first vertex. O(n).
Ring sutherland_hodgman(const Ring& ring, const ClipLine& line);
/// Against one line after the other.
Ring sutherland_hodgman(const Ring& ring, std::span<const ClipLine> lines);

/// A vertex with its name on paper.
struct LabelledVertex {
  Vec2d position{0};
  std::string label;
  bool is_new = false;  ///< a crossing made by clipping
};

struct ClipStep {
  std::string input;  ///< label
  ClipState state;
  std::vector<std::string> output;  ///< labels, in order
};

struct ClipTrace {
  std::vector<ClipStep> steps;  ///< one for each vertex, then once more the first
  std::vector<LabelledVertex> ring;
};

/// Clips and writes down each step. Crossings are named by the letters of `names` in turn; once they are used up, A1,
/// B1 and so on.
ClipTrace trace_clip(std::span<const LabelledVertex> ring, const ClipLine& line,
                     std::string_view names = "ABCDEFGHIJKLMNOPQRSTUVWXYZ");

/// The edges of a clipped ring between two new vertices, with the direction they have in it. While no vertex lies on
/// the line, and no two of its pieces in the polygon are neighbours joined by a bridge, these are the pieces of the
/// line inside the polygon; line_through.h finds them always.
std::vector<std::pair<LabelledVertex, LabelledVertex>> edges_of_new_vertices(const ClipTrace& trace);

}  // namespace lambert::polygon
