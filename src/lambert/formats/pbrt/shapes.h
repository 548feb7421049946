#pragma once
#include "lambert/formats/pbrt/context.h"

namespace lambert::pbrt {

/// Adds the geometry of `Shape "type"` to the scene's pool, in object space. Throws Error with the known types.
GeometryId add_geometry(Context& context, const ParameterList& list, const std::string& type);
std::vector<std::string> shape_types();

/// Area of one side in world space. For analytic shapes under an affine map that stretches unevenly it is that under
/// the similarity of the same volume.
float world_area(const Geometry& geometry, const Transform& to_world);

}  // namespace lambert::pbrt
