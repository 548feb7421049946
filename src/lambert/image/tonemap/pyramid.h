#pragma once
/// Gaussian pyramids (Burt and Adelson 1983): the kernel is 1 4 6 4 1 over 16, and planes go on at their edges.

#include "lambert/image/plane.h"

namespace lambert::tone {

/// Blurred, every second pixel in each direction: half the size, rounded up.
Plane halved(const Plane& plane);
/// The opposite: twice the size, interpolated; `width` and `height` are those that halved() made this one from.
Plane doubled(const Plane& plane, int width, int height);

}  // namespace lambert::tone
