#pragma once
#include "lambert/scene/scene_graph.h"

namespace lambert {

/// Throws Error naming the light, camera or material that has a number that is not finite. (Meshes and transforms are
/// checked when they enter the graph.)
void check_finite(const SceneGraph& graph);

}  // namespace lambert
