#pragma once
#include "lambert/formats/pbrt/context.h"

namespace lambert::pbrt {

TriangleMesh triangle_mesh(const ParameterList& list);
/// Each patch becomes two triangles; noted when a patch is not planar.
TriangleMesh bilinear_mesh(const Context& context, const ParameterList& list);
/// The cage of a Loop subdivision surface, with smooth normals.
TriangleMesh loop_subdivision_cage(const Context& context, const ParameterList& list);
/// A file that is named again is read once.
GeometryId add_ply_mesh(Context& context, const ParameterList& list);

/// Turns triangles whose vertex normals point to their back: where a mesh has normals, pbrt's outward side is theirs.
void orient_by_normals(TriangleMesh& mesh);

}  // namespace lambert::pbrt
