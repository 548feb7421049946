#pragma once
/// Scan conversion as in textbooks (rows PG-33, PG-34): edges meet whole scan lines by a digital differential analyser,
/// and the pixels between successive pairs are filled, the ends included. Neighbours share their common pixels; where
/// each pixel may belong to one polygon only, use scan_fill.h.

#include "lambert/polygon/ring.h"

#include <vector>

namespace lambert::polygon {

/// Pixels (x, y) with first <= x <= last.
struct PixelSpan {
  int y, first, last;
  bool operator==(const PixelSpan&) const = default;
};

/// Where an edge meets scan lines: from its lower end on, x is the nearest whole number to the crossing, halves up,
/// exactly, by whole steps alone.
class EdgeDda {
 public:
  /// From the lower to the upper end; low.y < high.y, coordinates within ±2^30.
  EdgeDda(Vec2i low, Vec2i high);

  int x() const { return static_cast<int>(x_); }
  /// To the scan line y + 1.
  void step();

 private:
  long x_, step_;                        ///< whole part of the crossing plus 1/2
  long remainder_, rest_, denominator_;  ///< its fraction, in 1/denominator
};

/// How far coordinates may lie from 0 in a table.
inline constexpr int scan_table_reach = 1 << 20;

/// The span table of rings of whole vertices, by y, then x; spans of a row neither touch nor overlap. On a scan line
/// through vertices, what the polygon covers just above it and just below, and its horizontal edges, are all filled: so
/// a corner that points up or down is filled with its one pixel and a horizontal edge in its whole length, whatever the
/// neighbouring edges do. Throws std::out_of_range where a
/// coordinate is beyond scan_table_reach. O(h log h) time and O(h) memory
/// for edges whose heights sum to h.
std::vector<PixelSpan> scan_table(const std::vector<std::vector<Vec2i>>& rings, FillRule rule = FillRule::even_odd);

/// The same of vertices rounded to the nearest whole numbers, halves up.
std::vector<PixelSpan> scan_table(const Rings& rings, FillRule rule = FillRule::even_odd);

}  // namespace lambert::polygon
