#pragma once
#include "verb.h"

#include "lambert/geometry/mesh.h"

#include <functional>

namespace lambert::cli {

/// Writes `mesh` to the outputs of `o` that name a mesh file and takes them out of it; true when none is left that asks
/// for more.
bool write_meshes(PolygonOptions& o, const std::function<TriangleMesh()>& mesh);

}  // namespace lambert::cli
