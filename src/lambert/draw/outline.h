#pragma once
#include "lambert/draw/drawing.h"

namespace lambert::draw {

/// The area of a stroke: to be filled by non-zero winding. Round joins and ends, round to a tenth of `pixel`.
Rings outline(const Stroke& stroke, double pixel = 1);
Ring circle(Vec2d centre, double radius, double pixel = 1);

}  // namespace lambert::draw
