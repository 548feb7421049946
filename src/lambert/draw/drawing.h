#pragma once
/// A picture as marks on a sheet, in pixels with y down: what is written as SVG or turned into pixels.

#include "lambert/polygon/box.h"
#include "lambert/polygon/ring.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace lambert::draw {

using polygon::Box2;
using polygon::FillRule;
using polygon::Ring;
using polygon::Rings;

/// sRGB, with opacity in [0, 1].
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  double opacity = 1;
  bool operator==(const Colour&) const = default;
  Colour with_opacity(double o) const { return {red, green, blue, o}; }
};

/// "#rrggbb", without the opacity.
std::string hex(const Colour& colour);
/// Light colours for pieces side by side, in which neighbours in the count differ most.
Colour pastel(std::size_t index);
/// Dark colours for lines, in the order of pastel's hues.
Colour strong(std::size_t index);

struct Fill {
  Rings rings;
  FillRule rule = FillRule::even_odd;
  Colour colour;
};

/// Round joins and ends.
struct Stroke {
  Ring points;
  bool closed = false;
  Colour colour;
  double width = 1, dash = 0;  ///< a dash of 0 is a whole line
};

struct Disk {
  Vec2d centre{0};
  double radius = 1;
  Colour colour;
};

enum class Anchor : std::uint8_t { start, middle, end };

struct Words {
  Vec2d at{0};  ///< on the base line
  std::string text;
  Colour colour;
  double size = 11;  ///< of the font
  Anchor anchor = Anchor::start;
  bool halo = false;  ///< a white edge that keeps it readable on lines
};

/// Later marks cover earlier ones.
struct Drawing {
  double width = 0, height = 0;
  std::vector<std::variant<Fill, Stroke, Disk, Words>> marks;
};

/// The drawing moved by `offset`.
Drawing moved(Drawing drawing, Vec2d offset);
/// Drawings side by side, row by row, in cells as large as the largest.
Drawing side_by_side(const std::vector<Drawing>& drawings, int columns);

}  // namespace lambert::draw
