#pragma once
#include "lambert/formats/pbrt/context.h"

namespace lambert::pbrt {

/// Adds the material of `Material "type"` or `MakeNamedMaterial` to the scene; none for the interface material. Throws
/// Error with the known types.
std::optional<MaterialId> add_material(Context& context, const ParameterList& list, const std::string& type,
                                       const std::string& name);
std::vector<std::string> material_types();

/// The same material, solid where `alpha` (a shape's parameter) is 1 and absent where it is 0.
MaterialId with_alpha(Context& context, MaterialId material, const FloatParameter& alpha);

}  // namespace lambert::pbrt
