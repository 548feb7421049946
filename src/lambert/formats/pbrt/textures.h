#pragma once
#include "lambert/formats/pbrt/spectra.h"

namespace lambert::pbrt {

/// A parameter that is a number or the name of a "float" texture.
FloatParameter float_parameter(const Context& context, const ParameterList& list, std::string_view name,
                               float fallback);
/// A parameter that is a spectrum of any kind or the name of a "spectrum" texture.
RgbParameter rgb_parameter(const Context& context, const ParameterList& list, std::string_view name, Rgb fallback,
                           SpectrumRole role);

/// `Texture "name" "float" "class" …`; `type` is "float" or "spectrum".
void add_float_texture(Context& context, const ParameterList& list, const std::string& name,
                       const std::string& type_class, const GraphicsState& state);
void add_spectrum_texture(Context& context, const ParameterList& list, const std::string& name,
                          const std::string& type_class, const GraphicsState& state);

std::vector<std::string> texture_classes();

}  // namespace lambert::pbrt
