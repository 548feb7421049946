#pragma once
#include "lambert/base/vec.h"
#include "lambert/image/image.h"

#include <cstddef>
#include <vector>

namespace lambert {

/// For every pixel, row by row, the nearest one (by Euclidean distance, exactly) whose channel `c` is above 0; (-1, -1)
/// when there is none. In linear time (Felzenszwalb and Huttenlocher 2012): columns first, then along rows the lower
/// envelope of the parabolas of the columns' distances.
std::vector<Vec2i> nearest_covered(const Image& image, std::size_t c);

}  // namespace lambert
