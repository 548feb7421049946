#pragma once
#include "lambert/image/hdr/stack.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambert::hdr {

/// The codes at which one channel tells of exposure: above `black` and below `saturated`. Code 0 may stand for any
/// little light, the top code for any much.
struct UsableCodes {
  int black = 0, saturated = 255;
  bool scattered = false;  ///< what was saturated has lower codes, too: lossy compression
  bool contains(int code) const { return code > black && code < saturated; }
};

/// Black is code 0. Saturated is the top code, or a lower one at which the two longest exposures both end with many
/// pixels (1 in 200 within a code of 8 bits): raw developers and some cameras clip there. Lossy compression scatters
/// what was saturated to codes below, in each channel differently: where pixels that are saturated in a shorter
/// exposure show that, saturated is the code that 199 in 200 of them reach, at most an eighth of the codes below.
UsableCodes usable_codes(const ExposureStack& stack, std::size_t channel);

/// Pixels of one channel with their codes in all frames.
struct Samples {
  std::size_t frames = 0;
  std::vector<double> log_exposures;  ///< by frame
  std::vector<std::uint16_t> codes;   ///< of sample i in frame j at [i * frames + j]; unusable where not covered
  std::vector<float> slopes;          ///< how fast the codes change there, in codes per pixel
  UsableCodes usable;
  std::size_t count() const { return frames ? codes.size() / frames : 0; }
};

/// By channel, up to some tens of thousands of pixels with at least two usable codes, spread over the image and over
/// the codes: a pixel is taken as long as one of its codes is still rare among those taken, and none has the same codes
/// in all frames: in a flat sky all share one error of rounding, which would pass for truth. The same ones every time.
std::vector<Samples> select_samples(const ExposureStack& stack);

}  // namespace lambert::hdr
