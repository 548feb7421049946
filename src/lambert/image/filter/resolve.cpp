#include "lambert/image/filter/resolve.h"

#include "lambert/base/error.h"
#include "lambert/image/filter/separable.h"

#include <algorithm>
#include <string>

namespace lambert {
namespace {

Taps resolving_taps(int n, int factor, ResolveKernel kernel) {
  Taps taps;
  for (int i = 0; i < n; i += factor) {
    for (int k = 0; k < factor; ++k)
      taps.add(i + k, kernel == ResolveKernel::box ? 1 : std::min(k + 1, factor - k), n, EdgeMode::clamp);
    taps.end_normalised(i, n, EdgeMode::clamp);
  }
  return taps;
}

}  // namespace

Image resolved(const Image& samples, int factor, ResolveKernel kernel) {
  if (factor < 1 || factor > 64) throw Error("expected a factor from 1 to 64, got " + std::to_string(factor));
  const int width = samples.width(), height = samples.height();
  if (width % factor != 0 || height % factor != 0)
    throw Error("samples must be a multiple of " + std::to_string(factor) + " along both axes, not " +
                std::to_string(width) + "x" + std::to_string(height));
  return separably_filtered(samples, resolving_taps(width, factor, kernel), resolving_taps(height, factor, kernel));
}

}  // namespace lambert
