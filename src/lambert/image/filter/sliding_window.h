#pragma once
#include "lambert/image/filter/edge_mode.h"
#include "lambert/image/image.h"

namespace lambert {

enum class WindowOperation { sum, least, greatest };

/// Each pixel becomes the sum, the least or the greatest of the (2 radius.x + 1) × (2 radius.y + 1) pixels around it,
/// per channel, at three operations a pixel and axis whatever the radius (van Herk 1992, Gil and Werman 1993); sums are
/// of at most 2 radius + 1 terms along an axis and never subtracted, so that nothing outside a window touches its
/// result. Of the least and the greatest, NaN is passed over unless it is all there is along a line. Windows and
/// metadata stay. Throws Error for a radius that is negative or above 65536.
Image slid(const Image& image, Vec2i radius, WindowOperation operation, EdgeMode edge);

}  // namespace lambert
