#pragma once
/// The pixels of polygons by the sampling rule of graphics hardware: a pixel belongs to what encloses its centre, and
/// of polygons that meet along a line through a centre exactly one gets it. So tilings cover each pixel once.

#include "lambert/polygon/ring.h"

#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

namespace lambert::polygon {

/// Pixels (x, y) with x_begin <= x < x_end and y_begin <= y < y_end. Pixel (x, y) is the square from there to
/// (x + 1, y + 1), its centre (x + 1/2, y + 1/2).
struct PixelWindow {
  int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;
  bool operator==(const PixelWindow&) const = default;
};

/// The least window that holds every pixel whose centre is in the box of the rings, as far as int reaches.
PixelWindow pixel_window(const Rings& rings);

/// Rules for winding numbers with a sign, besides those of FillRule.
inline constexpr auto positive_winding = [](int winding) { return winding > 0; };
inline constexpr auto negative_winding = [](int winding) { return winding < 0; };

/// One edge or several pass between the centres of the columns x - 1 and x of a row.
struct RowCrossing {
  int x;
  int winding;  ///< what the winding number gains there towards +x
  bool operator==(const RowCrossing&) const = default;
};

/// Walks up the rows of a window with a table of active edges. Each crossing is put between columns exactly
/// (orientation()); a centre on an edge lies on the side towards +x, on a horizontal edge on the side towards +y, which
/// is the top-left rule where y points down. O(edges log edges) once, O(active edges) in a row; columns clamp to the
/// window.
class ScanRows {
 public:
  /// Keeps a copy of the edges that the window meets. Coordinates must be finite.
  ScanRows(const Rings& rings, const PixelWindow& window);

  /// To the next row that edges cross; false after the last.
  bool next();
  int y() const { return y_; }
  /// Sorted by x.
  std::span<const RowCrossing> crossings() const { return crossings_; }

 private:
  struct Edge {
    Vec2d low, high;
    int winding, first_row, last_row;
    double slope;   ///< dx / dy
    double margin;  ///< bound of the error of a crossing computed with it
  };

  int column(const Edge& edge, double centre_y) const;
  void sort_crossings();

  PixelWindow window_;
  std::vector<Edge> edges_;  ///< by first row
  std::vector<Edge> active_;
  std::vector<RowCrossing> crossings_;
  std::vector<int> gains_;  ///< of each column
  std::size_t waiting_ = 0;
  int y_ = 0;
};

/// Calls span(y, x_begin, x_end) for each longest run of pixels in a row whose centres the rule encloses, by y, then x;
/// never an empty run. `rule` says whether a winding number is inside.
template <class Rule, class Span>
requires requires(const Rule& rule, int winding) { static_cast<bool>(rule(winding)); }
void for_each_span(const Rings& rings, const Rule& rule, const PixelWindow& window, Span&& span) {
  ScanRows rows(rings, window);
  while (rows.next()) {
    int winding = 0, begin = 0;
    bool open = false;
    const auto crossings = rows.crossings();
    for (std::size_t i = 0; i < crossings.size();) {
      const int x = crossings[i].x;
      for (; i < crossings.size() && crossings[i].x == x; ++i) winding += crossings[i].winding;
      const bool inside = static_cast<bool>(rule(winding));
      if (inside == open) continue;
      if (open) span(rows.y(), begin, x);
      open = inside;
      begin = x;
    }
  }
}

template <class Span>
void for_each_span(const Rings& rings, FillRule rule, const PixelWindow& window, Span&& span) {
  if (rule == FillRule::even_odd)
    for_each_span(
        rings, [](int winding) { return winding % 2 != 0; }, window, std::forward<Span>(span));
  else
    for_each_span(
        rings, [](int winding) { return winding != 0; }, window, std::forward<Span>(span));
}

}  // namespace lambert::polygon
