#pragma once
#include "lambert/base/progress.h"
#include "lambert/image/filter/taps.h"
#include "lambert/image/image.h"

namespace lambert {

/// Every channel filtered along columns by `rows`, then along rows by `columns`: as many pixels as the taps have
/// positions; the windows are left at the origin, metadata is copied. In parallel by tiles; the result does not depend
/// on the number of threads. Infinities and NaN reach every pixel that reads them with a weight that is not 0.
Image separably_filtered(const Image& image, const Taps& columns, const Taps& rows, const FractionSink& progress = {});

}  // namespace lambert
