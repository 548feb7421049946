#include "lambert/base/notes.h"
#include "lambert/scene/scene.h"

#include <algorithm>

namespace lambert {
namespace {

bool has_light(const SceneGraph& graph) {
  if (!graph.lights().empty()) return true;
  for (NodeId n = 0; n < graph.node_count(); ++n)
    for (const Surface& s : graph.surfaces(n))
      if (s.emission && s.emission->casts_light && !is_black(s.emission->radiance.value)) return true;
  return false;
}

}  // namespace

void add_missing_camera_and_light(SceneGraph& graph, Notes& notes, Vec2i resolution) {
  if (graph.cameras().empty()) {
    graph.add_camera(framing_camera(graph.world_bounds(graph.root()), resolution));
    notes.add("the scene has no camera: framed it as a whole");
  }
  if (!has_light(graph)) {
    graph.add_light(studio_environment());
    notes.add("the scene has no light: added a studio environment");
  }
}

}  // namespace lambert
