#pragma once
/// Photographs of known exposure and response to one map of radiance.

#include "lambert/base/progress.h"
#include "lambert/image/hdr/ghosts.h"
#include "lambert/image/hdr/noise.h"
#include "lambert/image/hdr/response.h"
#include "lambert/image/hdr/stack.h"
#include "lambert/image/image.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lambert::hdr {

/// What a code counts in the mean of X(code) / exposure. X is the exposure behind a code, X' its slope.
enum class Weighting {
  variance,   ///< exposure² / variance of X: X'² times that of the code, or with a SensorNoise Granados et al. 2010
  hat,        ///< Debevec and Malik 1997: distance to the nearer end of the codes
  gaussian,   ///< exp(-4 (code / middle - 1)²), the same for all exposures
  robertson,  ///< exposure² exp(-4 (code / middle - 1)²), Robertson et al. 2003
};
Weighting weighting(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> weighting_names();

struct MergeSettings {
  Weighting weights = Weighting::variance;
  CodeNoise code_noise;
  SensorNoise noise;  ///< with a full well, variances are those of the sensor, found in turns from the mean itself
  FractionSink progress = {};
};

struct Merged {
  Image image;  ///< R G B, or Y: radiance; metadata names exposures and response
  /// Pixels with a channel that is saturated in every photograph that shows them: that channel is the lower bound that
  /// the shortest exposure gives.
  std::size_t saturated = 0;
  /// Pixels with a channel that is black in every photograph: 0.
  std::size_t black = 0;
};

/// `ghosts` says which photographs not to use where. The result does not depend on the number of threads.
Merged merge(const ExposureStack& stack, const Response& response, const MergeSettings& settings = {},
             const GhostMasks& ghosts = {});

}  // namespace lambert::hdr
