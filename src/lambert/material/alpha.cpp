#include "lambert/material/material.h"

namespace lambert {

bool alpha_passes(const Material& material, const TextureSet& textures, const TextureCoordinates& at,
                  float vertex_alpha, float u) {
  if (material.alpha_mode == AlphaMode::opaque) return false;
  const float alpha = material.alpha.eval(textures, at) * vertex_alpha;
  return material.alpha_mode == AlphaMode::mask ? alpha < material.alpha_cutoff : alpha <= u;
}

}  // namespace lambert
