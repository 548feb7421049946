#pragma once
#include "lambert/draw/plot.h"

#include <string>
#include <utility>
#include <vector>

namespace lambert::draw {

/// The largest of 1, 2, 5 times a power of ten that is at most about `wanted` (positive and finite).
double round_step(double wanted);
/// Twelve digits: hides that steps such as 0.1 are no doubles.
std::string tick_text(double value);

/// Maps data to pixels along one axis of a plot.
class AxisScale {
 public:
  /// `values` are all data of the axis; those that cannot be shown are passed over. Pixel `begin` shows the low end,
  /// `end` the high one.
  AxisScale(const Axis& axis, const std::vector<double>& values, double begin, double end);

  /// Not finite for data that the axis cannot show.
  double pixel(double value) const;

  /// Round values, some `spacing` pixels apart, where they lie and how they are written; no text on minor ones.
  using Ticks = std::vector<std::pair<double, std::string>>;
  Ticks ticks(double spacing) const;

 private:
  double position(double value) const;  // value, or its logarithm
  Ticks decades(double spacing) const;

  bool logarithmic_;
  double low_, high_, begin_, end_;
};

}  // namespace lambert::draw
