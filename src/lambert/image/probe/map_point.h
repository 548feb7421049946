#pragma once
#include "lambert/base/vec.h"

namespace lambert::probe {

/// A place on a map: of a cube the face (px nx py ny pz nz), of all other maps chart 0.
struct MapPoint {
  int chart = 0;
  Vec2 uv{0};
};

}  // namespace lambert::probe
