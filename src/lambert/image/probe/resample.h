#pragma once
#include "lambert/base/progress.h"
#include "lambert/image/probe/layout.h"
#include "lambert/image/probe/rotation.h"

namespace lambert::probe {

struct ResampleSettings {
  Mat3 rotation{1};        ///< the environment is turned by it: what was seen along d is then seen along rotation · d
  float quality = 2;       ///< samples per texel of the source along each axis, where the map shrinks
  int most_per_axis = 96;  ///< samples of a texel along one axis; only at the rim of balls are more wanted
  FractionSink progress = {};
};

/// Another layout of the same environment, or a turned one: each texel is the mean over its solid angle of the source,
/// interpolated bilinearly, at points no more than half a source texel apart. Constant environments stay what they
/// are to 1e-5; mean radiance and irradiance of the sphere keep to 1e-3, to 1e-2 when all light is in one
/// texel. Where the source shows nothing, it counts as 0 in all channels. The same projection, size and no rotation
/// give the same bits. Values must be finite (fill_missing). `size` is a chart's; throws Error when it makes no image.
Probe resample(const Probe& source, const AnyProjection& projection, TexelRule texels, Vec2i size,
               const ResampleSettings& settings = {});

/// A chart's size in `projection` that has about the source's angular resolution.
Vec2i similar_size(const Probe& source, const AnyProjection& projection);

}  // namespace lambert::probe
