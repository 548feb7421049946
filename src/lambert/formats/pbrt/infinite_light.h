#pragma once
#include "lambert/formats/pbrt/context.h"

namespace lambert::pbrt {

/// `LightSource "infinite"`: constant "L", or the image "filename". A square image is pbrt's equal-area octahedral map
/// with +z up; any other is taken as latitude and longitude with +y up, which pbrt does not know.
EnvironmentLight infinite_light(const Context& context, const ParameterList& list, const GraphicsState& state);

}  // namespace lambert::pbrt
