#pragma once
#include "lambert/scene/scene_graph.h"

namespace lambert {

/// The Cornell box as measured (Cornell University Program of Computer Graphics, 1998: 552.8 x 548.8 x 559.2 mm room,
/// two blocks, one lamp), in metres, reflectances and lamp turned into RGB. The same scene is scenes/cornell-box/.
SceneGraph cornell_box();

}  // namespace lambert
