#pragma once
#include "lambert/image/plane.h"

namespace lambert::tone {

/// The bilateral filter: the mean of the plane with the weights of a Gaussian of the distance (standard deviation
/// `spatial`, pixels) times a Gaussian of the difference of values (`range`). Only pixels of the plane count.
///
/// By a bilateral grid (Paris and Durand 2006): values are spread over a coarse grid of place and value, blurred there
/// and looked up. Spreading and looking up by linear weights widen the kernel; the blur is narrower by as much. With
/// two cells to a standard deviation the result is within 0.03 `range` of the exact one. The cells of the grid are
/// bounded: values that spread over more than 200 times `range` are filtered with a wider one.
Plane bilateral_filter(const Plane& plane, float spatial, float range);

}  // namespace lambert::tone
