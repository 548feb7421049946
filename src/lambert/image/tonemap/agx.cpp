#include "lambert/image/tonemap/agx.h"

namespace lambert::tone {

float sigmoid_scale(float straight, float rise, float power) {
  // straight (1 + (straight/s)^p)^(-1/p) = rise, solved for s.
  const float beyond = std::max(straight / rise, 1.001f);
  return beyond * rise / std::pow(std::pow(beyond, power) - 1, 1 / power);
}

Matrix3d Agx::inset_matrix(double amount) {
  Primaries wide = rec709;
  for (Vec2d* primary : {&wide.red, &wide.green, &wide.blue})
    *primary = rec709.white + (*primary - rec709.white) / (1 - amount);
  return rgb_to_rgb(rec709, wide);
}

}  // namespace lambert::tone
