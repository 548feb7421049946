#pragma once
/// What each position of a filtered line reads: polyphase weights, computed once and used for every line.

#include "lambert/image/filter/edge_mode.h"
#include "lambert/image/filter/kernel.h"

#include <cstddef>
#include <span>
#include <vector>

namespace lambert {

struct Tap {
  int index;     ///< of the input, inside it
  float weight;  ///< never 0
};

class Taps {
 public:
  std::size_t size() const { return end_.size(); }  ///< positions of the output
  std::span<const Tap> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : end_[i - 1];
    return std::span(taps_).subspan(begin, end_[i] - begin);
  }
  /// The next position reads input `index` of a line of `n`, or what stands there by `edge`.
  void add(int index, double weight, int n, EdgeMode edge);
  /// Ends a position, whose weights (those that fell on black too) are divided by their sum; when that is 0, it reads
  /// `nearest` alone.
  void end_normalised(int nearest, int n, EdgeMode edge);
  /// Ends a position.
  void end();

 private:
  std::vector<Tap> taps_;
  std::vector<std::size_t> end_;
  std::vector<Tap> pending_;
  std::vector<double> weights_;  // of the pending ones
  double black_ = 0;             // the weight that fell outside
};

/// Output i of `out` lies at scale · (i + offset + 1/2) - 1/2 of a line of `in`: scale > 1 makes smaller.
struct LineMap {
  int in = 1, out = 1;
  double scale = 1, offset = 0;
};
/// The kernel around each output's place, widened by the scale when that makes smaller, sampled at the input's pixel
/// centres and normalised to sum 1.
Taps resampling_taps(const Kernel& kernel, const LineMap& map, EdgeMode edge);

/// Output i reads i - radius .. i + radius by `weights` (2 radius + 1 of them, as they are, in that order).
Taps convolution_taps(std::span<const double> weights, int n, EdgeMode edge);

/// The average by length when `in` pixels become `out` <= in: a pixel that is cut counts on both sides by its parts.
Taps area_taps(int in, int out);

/// Each position reads itself.
Taps identity_taps(int n);

}  // namespace lambert
