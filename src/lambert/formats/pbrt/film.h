#pragma once
/// What a file asks of the renderer: Film, PixelFilter, Sampler, Integrator.

#include "lambert/formats/pbrt/context.h"

namespace lambert::pbrt {

/// `Film "rgb"`: the resolution; the file's name goes to the scene's settings.
Vec2i read_film(Context& context, const ParameterList& list, const std::string& type);
void read_filter(Context& context, const ParameterList& list, const std::string& type);
void read_sampler(Context& context, const ParameterList& list, const std::string& type);
void read_integrator(Context& context, const ParameterList& list, const std::string& type);

inline constexpr Vec2i default_resolution{1280, 720};

}  // namespace lambert::pbrt
