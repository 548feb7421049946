#pragma once
/// Plots with axes, ticks and a legend.

#include "lambert/draw/drawing.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lambert::draw {

struct Axis {
  std::string label;
  bool logarithmic = false;         ///< values that are not positive are left out
  std::optional<double> low, high;  ///< what is shown; absent: all data with a little room
};

struct Series {
  enum class Mark : std::uint8_t { line, points, line_and_points, steps, area };

  std::string name;                   ///< in the legend; none when empty
  std::vector<Vec2d> points;          ///< a value that is not finite leaves a gap in the line
  Mark mark = Mark::line;             ///< area: filled from the line to 0 or, on a logarithmic axis, to the bottom
  std::optional<Colour> colour = {};  ///< absent: of the place in the plot
  double width = 1.6;                 ///< of the line; points are 1.5 times as large in radius
  bool dashed = false;
};

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  double width = 640, height = 420;  ///< pixels, legend included
};

/// The colour of a series that has none of its own.
Colour series_colour(std::size_t index);

/// Later series cover earlier ones; what lies outside of the axes is cut off. Any data, none too.
Drawing drawn(const Plot& plot);

}  // namespace lambert::draw
