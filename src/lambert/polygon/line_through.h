#pragma once
/// What of a line lies inside a polygon (PG-57 to PG-60): the machine that walks along the line from event to event and
/// stays right at vertices and along edges.

#include "lambert/polygon/clip_line.h"
#include "lambert/polygon/ring.h"

#include <optional>
#include <utility>
#include <vector>

namespace lambert::polygon {

enum class LineEventKind : std::uint8_t {
  edge_crossing,  ///< I: between two vertices
  vertex,         ///< V
  edge_on_line,   ///< E: a run of edges along the line
};

/// Where the boundary comes from and goes to.
enum class LineContext : std::uint8_t {
  crosses,
  minimum,  ///< both left of the line: nothing changes on the right
  maximum,  ///< both right of it
  within,   ///< the whole ring lies on the line
};

struct LineEvent {
  LineEventKind kind;
  LineContext context;
  std::size_t ring, vertex;  ///< of the crossing edge's first vertex, or of the run's first vertex on the line
  Vec2d from, to;            ///< in the order of the ring; the same but for edge_on_line
};

/// The machine's state: the polygon lies on both sides of the line, or on neither, or the line runs along an edge.
enum class LineState : std::uint8_t { outside, inside, edge_interior_left, edge_interior_right };

/// A piece of the line, in its direction.
struct LinePiece {
  Vec2d from, to;
  LineState state;
};

/// A vertex in which the state is the same before and after: `inside` where the tip of a notch touches the line,
/// `outside` where a corner does.
struct LineTouch {
  Vec2d point;
  LineState state;
};

/// All in order along the line.
struct LineThrough {
  std::vector<LineEvent> events;
  std::vector<LinePiece> inside;  ///< as long as possible: a touch does not end one
  std::vector<LinePiece> edges;   ///< where the line runs along the boundary; the state tells the interior's side
  std::vector<LineTouch> touches;
};

/// Walks along the line from tail to head and beyond both. Which side a vertex lies on, the order of crossings and what
/// comes together in one point are decided exactly (LineOrder); the points given are rounded as by
/// ClipLine::crossing, pieces whose ends round to the same point are left out. Any rings: repeated vertices, crossings
/// and edges that cover each other are allowed, edges that the fill rule does not see are not reported as pieces.
/// O(n + k log k) for k events. Nothing is found when tail and head coincide.
LineThrough line_through(const Rings& rings, Vec2d tail, Vec2d head, FillRule rule = FillRule::even_odd);

/// The simple case: crossings sorted along the line and taken in pairs, in and out (even-odd). Nothing when the line
/// touches a vertex, where pairs would go wrong. Same order and rounding as line_through.
std::optional<std::vector<std::pair<Vec2d, Vec2d>>> alternating_pairs(const Rings& rings, Vec2d tail, Vec2d head);

}  // namespace lambert::polygon
