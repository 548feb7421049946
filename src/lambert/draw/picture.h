#pragma once
/// Pictures that show what an algorithm did: areas, lines, points, numbered vertices and a legend, in the coordinates
/// of the data.

#include "lambert/draw/drawing.h"

#include <string>
#include <vector>

namespace lambert::draw {

struct Picture {
  struct Area {
    Rings rings;
    FillRule rule = FillRule::even_odd;
    Colour fill, edge;
    double edge_width = 1.2;
  };
  struct Line {
    Ring points;
    Colour colour;
    bool closed = false, arrows = false, dashed = false;
    double width = 1.4;
  };
  enum class Shape : std::uint8_t { disk, cross, circle };
  struct Point {
    Vec2d at{0};
    Colour colour;
    Shape shape = Shape::disk;
    double radius = 3;
  };
  struct Label {
    Vec2d at{0};
    std::string text;
    Colour colour;
    Vec2d away{0};  ///< the direction from `at` where there is room, y up; zero: centred on it
  };
  struct Entry {
    std::string text;
    Colour colour;
  };

  std::string title;
  std::vector<Area> areas;
  std::vector<Line> lines;
  std::vector<Point> points;
  std::vector<Label> labels;
  std::vector<Entry> legend;
};

/// Numbers the vertices 0, 1, … of each ring, starting at `first`, outside of the corner, and puts a disk on each; a
/// legend for people who read indices in messages.
void add_indices(Picture& picture, const Rings& rings, const Colour& colour, std::size_t first = 0);

struct PictureOptions {
  double width = 640;       ///< pixels
  double max_height = 640;  ///< pixels, title and legend apart
  bool grid = true;         ///< lines at round coordinates, with their numbers
};

/// Scales the picture to the sheet, all axes alike, y up. Covers no label by another: one that finds no room is left
/// out, and so are disks of vertices where they stand closer than their size. O(n log n). Any finite coordinates.
Drawing drawn(const Picture& picture, const PictureOptions& options = {});

}  // namespace lambert::draw
