#pragma once
#include "lambert/formats/pbrt/context.h"

namespace lambert::pbrt {

/// Adds the light of `LightSource "type"`. Throws Error with the known types.
void add_light(Context& context, const ParameterList& list, const std::string& type, const GraphicsState& state);
std::vector<std::string> light_types();

/// What `AreaLightSource "diffuse"` makes a shape emit, whose area (one side, world) is `area`.
Emission area_emission(Context& context, const ParameterList& list, float area);

}  // namespace lambert::pbrt
