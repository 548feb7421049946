#pragma once
#include <cstddef>
#include <vector>

namespace lambert::hdr {

/// The noise of a sensor: Poisson in the electrons that light sets free, normal in reading them.
struct SensorNoise {
  double full_well = 0;   ///< electrons at exposure 1; 0: no noise but the rounding to codes
  double read_noise = 0;  ///< standard deviation in electrons
};

/// The standard deviation of each code about what it should be, by channel and code, in codes. Empty: that of rounding.
struct CodeNoise {
  std::vector<std::vector<float>> deviation;
  float at(std::size_t channel, std::size_t code) const {
    return deviation.empty() ? 0.288675f : deviation[channel < deviation.size() ? channel : 0][code];
  }
};

}  // namespace lambert::hdr
