#pragma once
#include <functional>

namespace lambert {

/// How far a long work has come. Rates are per second of wall time since the start; 0 where unknown.
struct Progress {
  double fraction = 0;  ///< done, in [0,1]
  double elapsed_seconds = 0;
  double remaining_seconds = 0;
  double samples = 0, samples_per_second = 0;
  double rays = 0, rays_per_second = 0;
  double error = 0;  ///< estimated relative error of the image; 0 when not measured
};

/// Called now and then by long works, always from one thread at a time.
using ProgressSink = std::function<void(const Progress&)>;

}  // namespace lambert
