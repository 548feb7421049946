#pragma once
#include "lambert/image/hdr/align.h"
#include "lambert/image/hdr/grey.h"

#include <array>

namespace lambert::hdr {

/// How the codes of one picture are found from those of another of the same scene (a comparagram's mean and spread).
struct Transfer {
  std::array<float, 256> mean{};  ///< NaN where the code is too rare or the picture black or white
  double spread = 0;              ///< mean variance of the other's codes about `mean`
  std::size_t pixels = 0;
};

/// Over about 200000 pixels of `reference`, each compared with `other` where `motion` sees it.
Transfer transfer(const Grey& reference, const Grey& other, const Motion& motion);

/// The motion near `start` that makes (other - transfer(reference))² least: Gauss-Newton steps from the coarsest
/// picture on, pixels that differ much counting little.
Motion refined(const std::vector<Grey>& reference, const std::vector<Grey>& other, const Motion& start);

}  // namespace lambert::hdr
