#pragma once
#include "lambert/image/denoise/plane.h"

namespace lambert::denoise {

/// Replaces what is not finite, or too large to be squared, by the mean of what is finite around it, in the smallest
/// window that has any; by 0 where there is nothing within 64 pixels.
void repair(Plane& plane);

}  // namespace lambert::denoise
