#pragma once
/// What moved while the photographs were taken.

#include "lambert/image/hdr/noise.h"
#include "lambert/image/hdr/response.h"
#include "lambert/image/hdr/stack.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lambert::hdr {

/// Per frame and pixel, 1 where the frame is not to be used; empty for frames that are used everywhere.
struct GhostMasks {
  std::vector<std::vector<std::uint8_t>> rejected;
  std::size_t reference = 0;  ///< the frame that is used everywhere
  const std::uint8_t* row(std::size_t frame, int y, int width) const {
    if (frame >= rejected.size() || rejected[frame].empty()) return nullptr;
    return rejected[frame].data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
  std::size_t count() const;  ///< entries that are 1
};

/// The frame with most codes that are far from both ends.
std::size_t best_exposed(const ExposureStack& stack);

struct GhostSettings {
  std::optional<std::size_t> reference;  ///< which frame is believed; none: the one with most usable pixels
  CodeNoise noise;
  double threshold = 9;     ///< mean square of the difference, in variances, above which a frame moved
  double tolerance = 0.06;  ///< relative error of radiance that is no motion: response, shading of the lens
  int radius = 2;           ///< of the square over which the mean is taken, and 1 less than that of growth
};

/// Compares every frame with the reference: the squared difference of their radiances over the variance that noise,
/// slopes of the image and `tolerance` explain, averaged over the channels and a square. A bound (saturated, black)
/// differs from a value only where it is broken.
GhostMasks find_ghosts(const ExposureStack& stack, const Response& response, const GhostSettings& settings = {});

}  // namespace lambert::hdr
