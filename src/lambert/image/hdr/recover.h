#pragma once
/// The response of a camera from photographs of one scene whose exposures are known.

#include "lambert/image/hdr/noise.h"
#include "lambert/image/hdr/response.h"
#include "lambert/image/hdr/samples.h"

#include <string>
#include <string_view>
#include <vector>

namespace lambert::hdr {

enum class RecoveryMethod {
  automatic,  ///< log response, weights and smoothness from the noise found; then a known curve if it fits as well
  debevec,    ///< Debevec and Malik 1997: log response by codes, hat weights, smoothness λ
  robertson,  ///< Robertson, Borman and Stevenson 2003: radiance and response in turn
  mitsunaga,  ///< Mitsunaga and Nayar 1999, with the exposures trusted: a polynomial of degree 1 to 9
};
RecoveryMethod recovery_method(std::string_view name);  ///< throws Error for an unknown name
std::vector<std::string> recovery_method_names();

struct RecoverySettings {
  RecoveryMethod method = RecoveryMethod::automatic;
  /// debevec: λ for a hundred pixels, as many as the paper takes; it grows with their number.
  double smoothness = 20;
};

struct Recovery {
  Response response;
  CodeNoise noise;          ///< about what the response predicts
  std::size_t samples = 0;  ///< pixels that were used, over all channels
  std::string model;        ///< "recovered", or the known curve that the photographs agree with
};

/// Throws Error with the reason when the response cannot be told: fewer than two exposures, too few pixels that are
/// neither black nor saturated in two of them, too few different codes. `stack` is in order of exposure.
Recovery recover_response(const ExposureStack& stack, const RecoverySettings& settings = {});

/// The noise of the codes when `response` holds; that of rounding where too few pixels tell.
CodeNoise measure_noise(const ExposureStack& stack, const Response& response);

}  // namespace lambert::hdr
