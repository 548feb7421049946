#pragma once
#include "lambert/draw/picture.h"
#include "lambert/polygon/box.h"

#include <string>
#include <utility>
#include <vector>

namespace lambert::draw {

/// Where the data comes to lie on the sheet: within margins for the numbers of the grid and padding for labels, both
/// axes to one scale, y turned downwards.
class Sheet {
 public:
  static constexpr double margin = 36, padding = 18;

  /// `box` may be empty, a point or as large as doubles are.
  Sheet(const Box2& box, const PictureOptions& options, double title_height);

  double width() const { return width_; }
  double height() const { return height_; }
  /// What the margins leave, in pixels.
  const Box2& area() const { return area_; }

  Vec2d point(Vec2d p) const;
  Ring ring(const Ring& ring) const;
  Rings rings(const Rings& rings) const;

  /// Round coordinates, some 100 pixels apart, where they lie and how they are written.
  using Ticks = std::vector<std::pair<double, std::string>>;
  Ticks columns() const { return ticks(0); }
  Ticks rows() const { return ticks(1); }

 private:
  Ticks ticks(int axis) const;

  Vec2d half_centre_{0};   // half the data's centre: the whole might overflow
  double half_pixel_ = 1;  // half the data's units a pixel
  double width_, height_;
  Box2 area_;
};

}  // namespace lambert::draw
