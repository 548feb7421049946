#pragma once
#include "lambert/image/image.h"

namespace lambert {

enum class ResolveKernel {
  box,       ///< the notes' "averaging": 1/9 each of 3 × 3
  bartlett,  ///< (1 2 1)ᵀ (1 2 1) / 16 of 3 × 3; (1 2 … n … 2 1), doubled in the middle when even, of larger ones
};

/// Row AA-12: the pixels of an image that was supersampled `factor` times along both axes, each the weighted mean of
/// its own factor × factor samples. Throws Error unless the size is a multiple of `factor`, from 1 to 64.
Image resolved(const Image& samples, int factor = 3, ResolveKernel kernel = ResolveKernel::box);

}  // namespace lambert
