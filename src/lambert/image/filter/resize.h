#pragma once
#include "lambert/base/progress.h"
#include "lambert/image/filter/edge_mode.h"
#include "lambert/image/filter/kernel.h"
#include "lambert/image/image.h"

namespace lambert {

struct ResizeSettings {
  /// Its radius counts pixels of the coarser of both grids, at most 64.
  FilterSettings filter{.kind = FilterKind::mitchell};
  EdgeMode edge = EdgeMode::clamp;  ///< what stands around the data window
  FractionSink progress = {};
};

/// The image with a display window of `width` × `height`; the data window is scaled with it, outwards to whole pixels.
/// Every channel is filtered as the premultiplied linear light it is, separably: a result is the sum of the input's
/// pixels weighted by the kernel around the result's place, divided by the sum of the weights. Where a direction
/// becomes smaller the kernel is widened by the ratio; along one that keeps its size an interpolating kernel changes
/// nothing. Kernels with negative lobes (mitchell, catmull-rom, lanczos) can give values beyond the input's range.
/// Throws Error for a size that an Image cannot have, and for a filter out of range.
Image resized(const Image& image, int width, int height, const ResizeSettings& settings = {});

}  // namespace lambert
